#include "app/modelling/evaluation/tradeoff_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "app/runtime/progress.h"
#include "app/runtime/stopwatch.h"
#include "core/base/text.h"
#include "core/eval/evaluation.h"
#include "core/infer/estimate/quantile.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/kernels/hyperparameters.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::uint64_t kReferenceSeed = 1'000'003;  // seed independent of the points' seeds

bool hasEverything(const Scene& scene)
{
    return missingFeature(FeatureSet::Paf, scene.s).empty() && unknownMask(scene.truth) == 0;
}

/// Sums over scenes that have an estimate and a long run.
class TradeoffTally {
public:
    void add(std::size_t k, const Scene& scene, const TerrainEstimate& estimate,
             const TerrainEstimate& reference, double seconds)
    {
        const EstimateDistance d = distance(estimate, reference);
        mean_ += d.mean;
        quantile_ += d.quantile;
        const auto errors = binErrors(k, scene, {}, estimate);
        errors_.insert(errors_.end(), errors.begin(), errors.end());
        seconds_.push_back(seconds);
        draws_.push_back(static_cast<double>(estimate.draws.size()));
        if (estimate.converged) ++converged_;
    }

    TradePoint point(TradeSetting setting) const
    {
        const auto n = static_cast<double>(seconds_.size());
        const ErrorStatistics truth = statistics(errors_);
        return {.setting = std::move(setting),
                .seconds = quantile(seconds_, 0.5),
                .reference = {mean_ / n, quantile_ / n},
                .error = truth.mean,
                .crps = truth.crps,
                .draws = static_cast<int>(quantile(draws_, 0.5)),
                .converged = converged_ / n};
    }

    bool empty() const { return seconds_.empty(); }

private:
    double mean_ = 0.0, quantile_ = 0.0;
    double converged_ = 0.0;
    std::vector<BinError> errors_;
    std::vector<double> seconds_, draws_;
};

/// Returns an estimate and its processor time. A method that simulates the arm makes two estimates, one after another.
/// The second one is repeated and timed.
std::pair<SceneEstimate, double> timedEstimate(const Scene& scene, const EstimatorBundle& bundle,
                                               const Settings& settings)
{
    ProcessorStopwatch watch;
    SceneEstimate estimate = estimateScene(scene, bundle, settings);
    if (estimate.arm.empty()) return {std::move(estimate), watch.seconds()};
    watch = {};
    (void)estimateWith(scene, estimate.arm, bundle, settings);
    return {std::move(estimate), watch.seconds()};
}

/// Times one setting in this thread, scene after scene.
TradeoffTally timeSetting(const TradeSetting& trade, const std::vector<Scene>& scenes,
                          const std::vector<SceneEstimate>& reference,
                          const EstimatorBundle& bundle)
{
    // Factorises the models before the first timed scene, because they are factorised on first use.
    Settings once = trade.settings;
    once.draws = once.chains = 1;
    once.burnIn = 0;
    for (const Scene& scene : scenes) (void)estimateScene(scene, bundle, once);
    TradeoffTally tally;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        if (!reference[k].estimate) continue;
        Settings own = trade.settings;
        own.seed += k;
        const auto [estimate, seconds] = timedEstimate(scenes[k], bundle, own);
        if (estimate.estimate)
            tally.add(k, scenes[k], *estimate.estimate, *reference[k].estimate, seconds);
    }
    return tally;
}

}  // namespace

Result<std::vector<Scene>> tradeoffScenes(const std::string& path)
{
    const auto file = readScenes(path);
    if (!file) return file.error();
    std::vector<Scene> scenes;
    std::copy_if(file->scenes.begin(), file->scenes.end(), std::back_inserter(scenes),
                 hasEverything);
    if (scenes.empty()) return fileError(path, "no scene has every feature of s and every height");
    return scenes;
}

MethodTradeoff measureTradeoff(Method method, const std::vector<Scene>& scenes,
                               const EstimatorBundle& bundle, int referenceDraws,
                               std::uint64_t seed)
{
    const auto settings = tradeSettings(method, seed);
    Progress progress(fmt::format("{}: setting", name(method)),
                      static_cast<int>(scenes.size() + settings.size()));
    const auto reference = estimateScenes(
        scenes, bundle, referenceSettings(method, referenceDraws, seed + kReferenceSeed), 0.0,
        progress);
    MethodTradeoff measured{{}, {.method = method}};
    for (const SceneEstimate& scene : reference)
        if (scene.estimate) measured.reference.add(*scene.estimate);
    for (const TradeSetting& trade : settings) {
        const TradeoffTally tally = timeSetting(trade, scenes, reference, bundle);
        if (!tally.empty()) measured.points.push_back(tally.point(trade));
        progress.tick();
    }
    return measured;
}

std::string referenceText(const MethodTradeoff& measured)
{
    const ReferenceQuality& r = measured.reference;
    if (isClosedForm(r.method)) return {};
    std::string text =
        fmt::format("{:<10} {} draws, worst R-hat {}, worst effective draws {:.0f}, error of "
                    "the means {:.2f} mm\n",
                    name(r.method), r.draws, rhatText(r.rhat), r.ess, 1e3 * r.error);
    const int least = leastReferenceDraws(measured.points);
    if (r.draws < least)
        text += fmt::format(
            "{:<10} WARNING: fewer than {} draws, four times the longest setting's: distances "
            "are mostly the long run's own error\n",
            "", least);
    if (r.rhat > kRhatLimit)
        text +=
            fmt::format("{:<10} WARNING: R-hat above {}: let it run longer (--reference-sweeps)\n",
                        "", kRhatLimit);
    return text;
}

}  // namespace terratact
