#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/quality.h"

namespace terratact {

/// One way to estimate: the settings, and what is special about them.
struct TradeSetting {
    std::string
        varied;  ///< "draws", "chains", "precision", "inducing", "early stop" or a preset's name
    Settings settings;
    std::optional<Quality> preset;
};

/// The settings whose cost and error `tradeoff` measures for a method: the presets, and 1000 draws of 16
/// chains in single precision without inducing rows, with one thing varied at a time.  Closed forms have
/// nothing but their draws to vary.  The presets end as early as the program lets them; of the others all but
/// "early stop" use their whole budget.
std::vector<TradeSetting> tradeSettings(Method method, std::uint64_t seed);

/// The long run that the others are compared with: 16 chains of `draws` in all, double precision, all rows.
Settings referenceSettings(Method method, int draws, std::uint64_t seed);

/// What the long runs of a method came to: of R-hat and ESS the worst of their bins, over all scenes.
struct ReferenceQuality {
    Method method = Method::Local;
    int scenes = 0;
    int draws = 0;
    double rhat = 1.0;
    double ess = 0.0;  ///< the number of draws where nothing was sampled
    double error =
        0.0;  ///< [m] of the means by Monte Carlo: sd/√ESS, on average over bins and scenes

    void add(const TerrainEstimate& estimate);
};

/// How far two estimates of one scene lie apart [m], on average over the bins.
struct EstimateDistance {
    double mean = 0.0;      ///< |difference of the means|
    double quantile = 0.0;  ///< |difference of the 0.1 and 0.9 quantiles|
};
EstimateDistance distance(const TerrainEstimate& a, const TerrainEstimate& b);

/// What a setting came to, on average over the scenes.
struct TradePoint {
    TradeSetting setting;
    double seconds = 0.0;        ///< of processor time, median per scene
    EstimateDistance reference;  ///< [m] from the long run of the same method
    double error = 0.0;          ///< [m] mean |height − truth|
    double crps = 0.0;           ///< [m] mean
    int draws = 0;               ///< that were kept, median per scene
    double converged = 0.0;      ///< share of the scenes whose chains had converged
};

/// Draws of a long run that is worth comparing with: four times those of the point with most.
int leastReferenceDraws(std::span<const TradePoint> points);

/// What a preset was measured to cost and to err, with one method.
struct PresetCost {
    Method method = Method::Local;
    Quality quality = Quality::Balanced;
    int draws = 0, chains = 0, burnIn = 0, inducing = 0;  ///< Settings that were measured
    double milliseconds = 0.0;                            ///< per scene
    double offMm = 0.0;      ///< [mm] of the quantiles, from a long run
    double errorMm = 0.0;    ///< [mm] mean |height − truth|
    double converged = 0.0;  ///< share of the scenes whose chains had converged
    bool operator==(const PresetCost&) const = default;
};

/// Which points no other beats: none is cheaper with no larger error, nor as cheap with a smaller one.
/// Of equal points the first is on the front.  Throws std::invalid_argument unless both have one number per
/// point.
std::vector<bool> paretoFront(std::span<const double> cost, std::span<const double> error);

/// Which points are on a front.  Distances from a long run are of its own method and say nothing about another one, so
/// each method has a front of time and quantiles; a closed form, whose quantiles are exact, has none.
struct TradeFronts {
    std::vector<bool> reference;  ///< of time and quantiles, among the points of the same method
    std::vector<bool> truth;      ///< of time and error, among all
};
TradeFronts tradeFronts(std::span<const TradePoint> points);

}  // namespace terratact
