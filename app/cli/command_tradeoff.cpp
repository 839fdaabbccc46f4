#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "app/cli/commands.h"
#include "app/figures/tradeoff_figure.h"
#include "app/modelling/scene_estimates.h"
#include "app/modelling/tradeoff_csv.h"
#include "app/runtime/parallel.h"
#include "app/runtime/print_text.h"
#include "app/runtime/progress.h"
#include "app/runtime/stopwatch.h"
#include "core/base/text.h"
#include "core/eval/evaluation.h"
#include "core/eval/tradeoff.h"
#include "core/infer/estimate/quantile.h"
#include "core/learn/data/scene_file.h"
#include "core/store/file_group.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"

namespace terratact {

namespace {

constexpr std::uint64_t kReferenceSeed = 1'000'003;  // seed independent of the points' seeds

bool isUsable(const Scene& scene)
{
    return missingFeature(FeatureSet::Paf, scene.s).empty()
        && std::all_of(scene.truth.begin(), scene.truth.end(),
                       [](const auto& h) { return h.has_value(); });
}

Result<std::vector<Scene>> usableScenes(const std::string& path)
{
    const auto file = readScenes(path);
    if (!file) return file.error();
    std::vector<Scene> scenes;
    std::copy_if(file->scenes.begin(), file->scenes.end(), std::back_inserter(scenes), isUsable);
    if (scenes.empty()) return fileError(path, "no scene has every feature of s and every height");
    return scenes;
}

/// Returns one estimate per scene, empty if the method has none. Scene k uses settings.seed + k.
std::vector<SceneEstimate> estimates(const std::vector<Scene>& scenes,
                                     const EstimatorBundle& bundle, const Settings& settings,
                                     Progress& progress)
{
    std::vector<SceneEstimate> all(scenes.size());
    parallelFor(static_cast<int>(scenes.size()), [&](int n) {
        const auto k = static_cast<std::size_t>(n);
        Settings own = settings;
        own.seed += k;
        all[k] = estimateScene(scenes[k], bundle, own);
        progress.tick();
    });
    return all;
}

/// Sums over scenes that have an estimate and a long run.
class Tally {
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
Tally timed(const TradeSetting& trade, const std::vector<Scene>& scenes,
            const std::vector<SceneEstimate>& reference, const EstimatorBundle& bundle)
{
    // Factorises the models before the first timed scene, because they are factorised on first use.
    Settings once = trade.settings;
    once.draws = once.chains = 1;
    once.burnIn = 0;
    for (const Scene& scene : scenes) (void)estimateScene(scene, bundle, once);
    Tally tally;
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

/// Measurements of one method.
struct Measured {
    std::vector<TradePoint> points;
    ReferenceQuality reference;
};

Measured measure(Method method, const std::vector<Scene>& scenes, const EstimatorBundle& bundle,
                 const TradeoffOptions& options)
{
    const auto settings = tradeSettings(method, options.seed);
    Progress progress(fmt::format("{}: setting", name(method)),
                      static_cast<int>(scenes.size() + settings.size()));
    const auto reference = estimates(
        scenes, bundle,
        referenceSettings(method, options.referenceDraws, options.seed + kReferenceSeed), progress);
    Measured measured{{}, {.method = method}};
    for (const SceneEstimate& scene : reference)
        if (scene.estimate) measured.reference.add(*scene.estimate);
    for (const TradeSetting& trade : settings) {
        const Tally tally = timed(trade, scenes, reference, bundle);
        if (!tally.empty()) measured.points.push_back(tally.point(trade));
        progress.tick();
    }
    return measured;
}

/// Returns the convergence of the long reference runs, and whether they are long enough.
std::string referenceText(const Measured& measured)
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

}  // namespace

std::vector<std::string> tradeoffFiles()
{
    return {"tradeoff.csv", "presets.csv", "tradeoff.png", "tradeoff.svg"};
}

Status tradeoff(const TradeoffOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    const auto scenes = usableScenes(options.data);
    if (!scenes) return scenes.error();
    const std::filesystem::path out(options.out);
    if (Status made = makeDirectory(options.out); !made) return made;

    std::vector<TradePoint> points;
    std::string references;
    for (const Method method : options.methods) {
        const Measured more = measure(method, *scenes, **bundle, options);
        points.insert(points.end(), more.points.begin(), more.points.end());
        references += referenceText(more);
    }
    if (points.empty()) return fileError(options.data, "no method has an estimate of any scene");
    FileGroup group;
    if (Status s = group.add((out / "tradeoff.csv").string(), tradeoffCsv(points)); !s) return s;
    if (Status s = group.add((out / "presets.csv").string(),
                             presetsCsv((*bundle)->model.contentHash, points));
        !s)
        return s;
    for (const char* file : {"tradeoff.png", "tradeoff.svg"})
        if (Status s = writeTradeoffFigure((out / file).string(), points, group.writer()); !s)
            return s;
    if (Status s = group.commit(); !s) return s;
    printText("{} scenes; the long runs, over all scenes and sampled bins:\n{}\n{}\nwritten to "
              "{}: tradeoff as CSV, "
              "PNG and SVG; presets.csv\n",
              scenes->size(), Lines(references), Lines(tradeoffTable(points)), options.out);
    return Done{};
}

}  // namespace terratact
