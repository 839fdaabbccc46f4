#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/eval/evaluation.h"

namespace terratact {

// PNG or SVG by the path's ending, under a temporary name, then renamed.  1200 × 700 px, 1800 × 700 where
// there are more than five series.  Methods have strong colours, baselines are grey and hollow.

/// The paper's Fig. 8: how often |error| falls into each class, one bar per label, as a share of its errors.
/// Throws std::invalid_argument for no histograms or histograms of different classes.
Status writeHistogramFigure(const std::string& path, std::span<const ErrorHistogram> histograms);

/// The paper's Fig. 9: per bin and label the median of |error| and a bar from the first to the third
/// quartile.  Throws std::invalid_argument for no summaries.
Status writeQuartileFigure(const std::string& path, std::span<const MethodSummary> summaries);

/// Histograms of the PIT, one panel per label, beside the level of a calibrated forecast; 1200 px wide,
/// three panels a row.  Throws as writeHistogramFigure.
Status writePitFigure(const std::string& path, std::span<const ErrorHistogram> histograms);

}  // namespace terratact
