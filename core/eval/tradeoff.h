#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/quality_preset.h"

namespace terratact {

/// One setting of an estimate, and what it varies.
struct TradeSetting {
    /// "draws", "chains", "precision", "inducing", "early stop" or a preset's name.
    std::string varied;
    Settings settings;
    std::optional<QualityPreset> preset;
};

/// Returns the settings whose cost and error `tradeoff` measures for a method: the presets, and
/// variations of one setting at a time. The base is 1000 draws of 16 chains in single precision
/// without inducing rows. Closed forms only vary their draws. The presets end as early as the
/// program allows; all others except "early stop" use their whole budget.
std::vector<TradeSetting> tradeSettings(Method method, std::uint64_t seed);

/// Returns the settings of the reference run: 16 chains with `draws` in all, double precision, all
/// rows.
Settings referenceSettings(Method method, int draws, std::uint64_t seed);

/// Quality of a method's reference runs: the worst R-hat and ESS of their bins, over all scenes.
struct ReferenceQuality {
    Method method = Method::Local;
    int scenes = 0;
    int draws = 0;
    double rhat = 1.0;
    double ess = 0.0;  ///< number of draws if nothing was sampled
    /// Monte-Carlo error of the means [m]: sd/√ESS, averaged over bins and scenes.
    double error = 0.0;

    void add(const TerrainEstimate& estimate);
};

/// Distance of two estimates of one scene [m], averaged over the bins.
struct EstimateDistance {
    double mean = 0.0;      ///< |difference of the means|
    double quantile = 0.0;  ///< |difference of the 0.1 and 0.9 quantiles|
};
EstimateDistance distance(const TerrainEstimate& a, const TerrainEstimate& b);

/// Result of one setting, averaged over the scenes.
struct TradePoint {
    TradeSetting setting;
    double seconds = 0.0;        ///< processor time, median per scene [s]
    EstimateDistance reference;  ///< distance from the reference run of the same method [m]
    double error = 0.0;          ///< mean |height − truth| [m]
    double crps = 0.0;           ///< mean CRPS [m]
    int draws = 0;               ///< kept draws, median per scene
    double converged = 0.0;      ///< share of the scenes with converged chains
};

/// Returns the least useful number of draws of a reference run: four times those of the point with
/// most draws.
int leastReferenceDraws(std::span<const TradePoint> points);

/// Measured cost and error of a preset with one method.
struct PresetCost {
    Method method = Method::Local;
    QualityPreset preset = QualityPreset::Balanced;
    int draws = 0, chains = 0, burnIn = 0, inducing = 0;  ///< the measured settings
    double milliseconds = 0.0;                            ///< per scene
    double offMm = 0.0;      ///< distance of the quantiles from a reference run [mm]
    double errorMm = 0.0;    ///< mean |height − truth| [mm]
    double converged = 0.0;  ///< share of the scenes with converged chains
    bool operator==(const PresetCost&) const = default;
};

/// Returns which points are on the Pareto front. No other point is cheaper with no larger error, or
/// as cheap with a smaller error. Of equal points the first is on the front. Throws
/// std::invalid_argument unless both have one number per point.
std::vector<bool> paretoFront(std::span<const double> cost, std::span<const double> error);

/// Pareto fronts of the points. Distances from a reference run compare one method only, so each
/// method has its own front of time and quantiles. A closed form has none, because its quantiles
/// are exact.
struct TradeFronts {
    std::vector<bool> reference;  ///< time and quantiles, among the points of the same method
    std::vector<bool> truth;      ///< time and error, among all points
};
TradeFronts tradeFronts(std::span<const TradePoint> points);

}  // namespace terratact
