#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/eval/evaluation.h"
#include "core/store/file_group.h"

namespace terratact {

// Figures are PNG or SVG by the file ending, written under a temporary name and renamed. They are 1200 × 700 px, or
// 1800 × 700 px for more than five series. `write` writes the file instead. Methods have strong colours; baselines are
// grey and hollow.

/// Draws the paper's Fig. 8: the share of errors in each class of |error|, one bar per label. Throws
/// std::invalid_argument for no histograms or histograms of different classes.
Status writeHistogramFigure(const std::string& path, std::span<const ErrorHistogram> histograms,
                            const FileWriter& write = {});

/// Draws the paper's Fig. 9: median and quartiles of |error| per bin and label. Throws std::invalid_argument for no
/// summaries.
Status writeQuartileFigure(const std::string& path, std::span<const MethodSummary> summaries,
                           const FileWriter& write = {});

/// Draws PIT histograms, one panel per label, with the level of a calibrated forecast. The figure is 1200 px wide with
/// three panels per row. Throws the exceptions of writeHistogramFigure().
Status writePitFigure(const std::string& path, std::span<const ErrorHistogram> histograms,
                      const FileWriter& write = {});

}  // namespace terratact
