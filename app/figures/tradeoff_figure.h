#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/eval/tradeoff.h"

namespace terratact {

/// Time per scene (logarithmic) against the distance of the quantiles from a long run (logarithmic), and against the
/// error: two panels, one marker per point in its method's colour, the Pareto fronts as lines, the presets with
/// their names.  PNG or SVG by the path's ending, 1800 × 760 px, under a temporary name, then renamed.
/// Throws std::invalid_argument for no points.
Status writeTradeoffFigure(const std::string& path, std::span<const TradePoint> points);

}  // namespace terratact
