#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/eval/tradeoff.h"
#include "core/store/file_group.h"

namespace terratact {

/// Draws time per scene against the quantiles' distance from a long run, and against the error; all scales are
/// logarithmic. Each of the two panels has one marker per point, in its method's colour. Pareto fronts are lines, and
/// presets have names. PNG or SVG by the file ending, 1800 × 760 px, written under a temporary name and renamed. Throws
/// std::invalid_argument for no points.
Status writeTradeoffFigure(const std::string& path, std::span<const TradePoint> points,
                           const FileWriter& write = {});

}  // namespace terratact
