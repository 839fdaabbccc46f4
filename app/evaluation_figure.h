#pragma once

#include <span>
#include <string>

#include "core/eval/evaluation.h"
#include "core/result.h"

namespace terratact {

/// The paper's Fig. 8, 1200 × 700 px: how often |error| falls into each class, one bar per method, as a
/// share of the method's errors.  PNG or SVG by the path's ending, under a temporary name, then renamed.
/// Throws std::invalid_argument for no histograms or histograms of different classes.
Status writeHistogramFigure(const std::string& path, std::span<const ErrorHistogram> histograms);

/// The paper's Fig. 9, 1200 × 700 px: per bin and method the median of |error| and a bar from the first to
/// the third quartile.  Written as above.  Throws std::invalid_argument for no summaries.
Status writeQuartileFigure(const std::string& path, std::span<const MethodSummary> summaries);

}  // namespace terratact
