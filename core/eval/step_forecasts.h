#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/eval/cluster_bootstrap.h"
#include "core/infer/estimate/estimate.h"
#include "core/learn/data/scene.h"

namespace terratact {

/// Place of a step: anywhere, or ahead of the robot (all its bins at +0.3 m or more).
enum class StepPlace : std::uint8_t { Anywhere, Ahead };
inline constexpr std::array kStepPlaces{StepPlace::Anywhere, StepPlace::Ahead};

/// Returns "anywhere" or "ahead".
std::string_view name(StepPlace place);

/// A method's forecast of a step in one scene, and the observation.
struct StepForecast {
    std::size_t scene = 0;
    std::string label;
    StepPlace place = StepPlace::Anywhere;
    double probability = 0.0;
    bool observed = false;
};

/// Returns one forecast per place in which all true heights are known; none without draws.
/// hasStep() defines a step of more than `limit` [m].
std::vector<StepForecast> stepForecasts(std::size_t sceneIndex, const Scene& scene,
                                        const std::string& label, const TerrainEstimate& estimate,
                                        double limit);

/// Forecasts in (k/10 … (k + 1)/10]; the first class includes 0.
struct ReliabilityClass {
    std::size_t n = 0;
    double meanForecast = 0.0;
    double observedShare = 0.0;
};
inline constexpr std::size_t kReliabilityClasses = 10;

/// Brier score mean (p − o)² of one label and place, and its decomposition over the ten classes:
///   reliability Σ nₖ (p̄ₖ − ōₖ)² / n, resolution Σ nₖ (ōₖ − ō)² / n, uncertainty ō (1 − ō).
/// score = reliability − resolution + uncertainty if the forecasts of a class are equal; it holds
/// approximately otherwise. Source: Murphy, J. Appl. Meteorol. 12 (1973).
struct BrierSummary {
    std::string label;
    StepPlace place = StepPlace::Anywhere;
    std::size_t n = 0;
    double observedShare = 0.0;  ///< ō
    double score = 0.0;
    double reliability = 0.0, resolution = 0.0, uncertainty = 0.0;
    /// 95 % interval of the score; empty for fewer than kMinRuns drives
    std::optional<Interval> interval;
    std::array<ReliabilityClass, kReliabilityClasses> classes{};
};

/// Returns one summary per label and place that has forecasts, labels by first appearance. Throws
/// std::invalid_argument if a forecast's scene is not among the scenes, or resamples < 1.
std::vector<BrierSummary> brierSummaries(std::span<const StepForecast> forecasts,
                                         std::span<const Scene> scenes, std::uint64_t seed,
                                         int resamples = 2000);

}  // namespace terratact
