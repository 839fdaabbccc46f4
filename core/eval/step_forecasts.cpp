#include "core/eval/step_forecasts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "core/base/named.h"
#include "core/infer/verdict/obstacle.h"

namespace terratact {
namespace {

constexpr auto kStepPlaceNames = namesOf<StepPlace>("anywhere", "ahead");

int firstBin(StepPlace place)
{
    return place == StepPlace::Ahead ? kFirstAhead : 0;
}

/// Returns true if there is a step; empty if a height is unknown.
std::optional<bool> trueStep(const OptionalHeights& truth, int first, double limit)
{
    Heights heights{};
    for (auto i = static_cast<std::size_t>(first); i < kBins; ++i) {
        if (!truth[i]) return std::nullopt;
        heights[i] = *truth[i];
    }
    return hasStep(heights, limit, first);
}

std::size_t classOf(double probability)
{
    constexpr auto kClasses = static_cast<double>(kReliabilityClasses);
    const double k = std::ceil(probability * kClasses) - 1.0;
    return static_cast<std::size_t>(std::clamp(k, 0.0, kClasses - 1.0));
}

double squaredError(const StepForecast& f)
{
    const double error = f.probability - (f.observed ? 1.0 : 0.0);
    return error * error;
}

/// Computes classes, score and its parts; forecasts: at least one, of one label and place.
BrierSummary decompose(std::span<const StepForecast> forecasts)
{
    BrierSummary b;
    b.label = forecasts.front().label;
    b.place = forecasts.front().place;
    b.n = forecasts.size();
    const auto n = static_cast<double>(b.n);
    for (const StepForecast& f : forecasts) {
        ReliabilityClass& c = b.classes[classOf(f.probability)];
        ++c.n;
        c.meanForecast += f.probability;
        c.observedShare += f.observed ? 1.0 : 0.0;
        b.observedShare += (f.observed ? 1.0 : 0.0) / n;
        b.score += squaredError(f) / n;
    }
    for (ReliabilityClass& c : b.classes) {
        if (c.n == 0) continue;
        const auto size = static_cast<double>(c.n);
        c.meanForecast /= size;
        c.observedShare /= size;
        b.reliability += size / n * std::pow(c.meanForecast - c.observedShare, 2);
        b.resolution += size / n * std::pow(c.observedShare - b.observedShare, 2);
    }
    b.uncertainty = b.observedShare * (1.0 - b.observedShare);
    return b;
}

std::optional<Interval> scoreInterval(std::span<const StepForecast> forecasts,
                                      const std::vector<std::size_t>& driveOfScene,
                                      std::uint64_t seed, int resamples)
{
    std::map<std::size_t, std::size_t> number;
    std::vector<std::pair<double, std::size_t>> values;
    for (const StepForecast& f : forecasts) {
        if (f.scene >= driveOfScene.size())
            throw std::invalid_argument("brierSummaries: a forecast of a scene that is not there");
        values.emplace_back(squaredError(f),
                            number.try_emplace(driveOfScene[f.scene], number.size()).first->second);
    }
    if (number.size() < kMinRuns) return std::nullopt;
    const ClusteredValues clustered(std::move(values));
    return interval95(
        bootstrapDrives(number.size(), seed, resamples,
                        [&](const DriveWeights& weight) { return clustered.mean(weight); }));
}

}  // namespace

std::string_view name(StepPlace place)
{
    return nameIn(kStepPlaceNames, place);
}

std::vector<StepForecast> stepForecasts(std::size_t sceneIndex, const Scene& scene,
                                        const std::string& label, const TerrainEstimate& estimate,
                                        double limit)
{
    std::vector<StepForecast> forecasts;
    if (estimate.draws.empty()) return forecasts;
    for (const StepPlace place : kStepPlaces) {
        const std::optional<bool> observed = trueStep(scene.truth, firstBin(place), limit);
        if (!observed) continue;
        const double p = anyStep(estimate, limit, firstBin(place)).p;
        forecasts.push_back({sceneIndex, label, place, p, *observed});
    }
    return forecasts;
}

std::vector<BrierSummary> brierSummaries(std::span<const StepForecast> forecasts,
                                         std::span<const Scene> scenes, std::uint64_t seed,
                                         int resamples)
{
    const std::vector<std::size_t> driveOfScene = driveNumbers(scenes);
    std::vector<std::pair<std::string, StepPlace>> keys;
    for (const StepForecast& f : forecasts)
        if (std::find(keys.begin(), keys.end(), std::pair(f.label, f.place)) == keys.end())
            keys.emplace_back(f.label, f.place);
    std::vector<BrierSummary> summaries;
    for (const auto& [label, place] : keys) {
        std::vector<StepForecast> own;
        for (const StepForecast& f : forecasts)
            if (f.label == label && f.place == place) own.push_back(f);
        BrierSummary summary = decompose(own);
        summary.interval = scoreInterval(own, driveOfScene, seed, resamples);
        summaries.push_back(std::move(summary));
    }
    return summaries;
}

}  // namespace terratact
