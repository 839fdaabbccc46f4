#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/eval/tradeoff.h"

namespace terratact {

/// One line per point: method,varied,draws,chains,burn_in,precision,inducing,used,converged,ms,mean_off_mm,
/// quantile_off_mm,error_mm,crps_mm,front_reference,front_truth.  draws: at most; used: of these, median; converged: share
/// of scenes.  The last two: 1 where the point is on the Pareto front of time and quantile_off of its method, of time
/// and error among all methods.
std::string tradeoffCsv(std::span<const TradePoint> points);

/// The same as a table to read, times and distances rounded.
std::string tradeoffTable(std::span<const TradePoint> points);

/// What presets cost with one model, and with no other.
struct PresetTable {
    std::string model{};  ///< its StoredModel::contentHash
    std::vector<PresetCost> costs{};
};

/// model,method,quality,draws,chains,burn_in,inducing,ms,quantile_off_mm,error_mm,converged of the points that are
/// presets.
std::string presetsCsv(std::string_view model, std::span<const TradePoint> points);

/// Reads what presetsCsv wrote.  Errors name file, line and cause.
Result<PresetTable> readPresets(const std::string& path);

}  // namespace terratact
