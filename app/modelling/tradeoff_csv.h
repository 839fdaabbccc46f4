#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/eval/tradeoff.h"

namespace terratact {

/// Returns one line per point:
///   method,varied,draws,chains,burn_in,precision,inducing,used,converged,ms,mean_off_mm,
///   quantile_off_mm,error_mm,crps_mm,front_reference,front_truth
/// draws: maximum; used: median of the draws taken; converged: share of scenes. front_reference: 1 on the Pareto front
/// of time and quantile_off of its method. front_truth: 1 on the Pareto front of time and error of all methods.
std::string tradeoffCsv(std::span<const TradePoint> points);

/// Returns the points as a table for the terminal, with times and distances rounded.
std::string tradeoffTable(std::span<const TradePoint> points);

/// Costs of the presets with one model; they hold for no other model.
struct PresetTable {
    std::string model{};  ///< StoredModel::contentHash of that model
    std::vector<PresetCost> costs{};
};

/// Returns model,method,quality,draws,chains,burn_in,inducing,ms,quantile_off_mm,error_mm,converged for the points that
/// are presets.
std::string presetsCsv(std::string_view model, std::span<const TradePoint> points);

/// Reads the output of presetsCsv(). Errors name file, line and cause.
Result<PresetTable> readPresets(const std::string& path);

}  // namespace terratact
