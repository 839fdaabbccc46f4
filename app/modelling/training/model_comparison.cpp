#include "app/modelling/training/model_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

#include "app/modelling/scene_estimates.h"
#include "app/runtime/parallel.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/model/file/model_file.h"
#include "core/learn/model/surface_rows.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"

namespace terratact {

namespace {

constexpr int kResamples = 2000;

Result<std::unique_ptr<EstimatorBundle>> bundleFrom(const RobotModel& robot,
                                                    const std::string& path)
{
    auto model = readModel(path);
    if (!model) return model.error();
    return std::make_unique<EstimatorBundle>(robot, std::move(*model));
}

/// The estimates of one scene by both models.
struct EstimatePair {
    SceneEstimate before, after;
    bool both() const { return before.estimate && after.estimate; }
};

std::vector<EstimatePair> estimatePairs(const std::vector<Scene>& scenes,
                                        const EstimatorBundle& before, const EstimatorBundle& after,
                                        const ComparisonPlan& plan, const ComparisonWatch& watch)
{
    std::vector<EstimatePair> pairs(scenes.size());
    std::mutex mutex;
    std::size_t done = 0;
    parallelFor(
        static_cast<int>(scenes.size()),
        [&](int k) {
            if (watch.cancelled && watch.cancelled()) throw Cancelled{};
            const auto i = static_cast<std::size_t>(k);
            Settings settings = plan.settings;
            settings.seed += i;
            settings.hazardRate = 0.0;  // compares the bands without hazard rate
            pairs[i] = {estimateScene(scenes[i], before, settings),
                        estimateScene(scenes[i], after, settings)};
            const std::scoped_lock lock(mutex);
            ++done;
            if (watch.progress)
                watch.progress(static_cast<double>(done) / static_cast<double>(scenes.size()));
        },
        plan.threads);
    return pairs;
}

using Errors = std::vector<BinError>;

MethodSummary summaryOf(const Errors& errors)
{
    return summarise(errors).front();
}

/// Returns the interval of |new error| − |old error| over the bins near the robot, bootstrapped over drives.
std::optional<Interval> differenceOf(const Errors& before, const Errors& after,
                                     const std::vector<Scene>& scenes, std::uint64_t seed)
{
    const std::vector<std::size_t> drives = driveNumbers(scenes);
    std::vector<std::pair<double, std::size_t>> differences;
    std::vector<bool> seen(scenes.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
        if (before[k].bin > kLastNearBin) continue;
        const std::size_t drive = drives[before[k].scene];
        seen[drive] = true;
        differences.emplace_back(std::abs(after[k].error) - std::abs(before[k].error), drive);
    }
    if (static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true)) < kMinRuns)
        return std::nullopt;
    const ClusteredValues values(std::move(differences));
    return interval95(
        bootstrapDrives(values.drives(), seed, kResamples,
                        [&](const DriveWeights& weight) { return values.mean(weight); }));
}

}  // namespace

std::vector<std::size_t> evenlyPicked(std::size_t count, std::size_t most)
{
    const std::size_t picked = std::min(count, most);
    std::vector<std::size_t> indices(picked);
    for (std::size_t k = 0; k < picked; ++k) indices[k] = k * count / picked;
    return indices;
}

Result<ModelComparison> compareModels(const ComparisonPlan& plan, const ComparisonWatch& watch)
{
    const auto file = readScenesWithTruth(plan.data);
    if (!file) return file.error();
    const std::vector<Scene>& known = file->scenes;
    const auto before = bundleFrom(plan.robot, plan.oldModel);
    if (!before) return before.error();
    const auto after = bundleFrom(plan.robot, plan.newModel);
    if (!after) return after.error();

    std::vector<Scene> scenes;
    for (const std::size_t k : evenlyPicked(known.size(), plan.mostScenes))
        scenes.push_back(known[k]);
    const std::vector<EstimatePair> pairs = estimatePairs(scenes, **before, **after, plan, watch);

    ModelComparison comparison;
    comparison.inFile = known.size();
    comparison.tried = scenes.size();
    comparison.dataHash = file->hash;
    comparison.newContent = (*after)->model.contentHash;
    Errors ofBefore, ofAfter;
    std::vector<Scene> judged;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const EstimatePair& pair = pairs[k];
        if (pair.both()) {
            judged.push_back(scenes[k]);
            const auto add = [&](Errors& errors, const SceneEstimate& estimate) {
                const Errors more = binErrors(k, scenes[k], "model", *estimate.estimate);
                errors.insert(errors.end(), more.begin(), more.end());
            };
            add(ofBefore, pair.before);
            add(ofAfter, pair.after);
            continue;
        }
        if (pair.before.estimate) ++comparison.onlyBefore;
        if (pair.after.estimate) ++comparison.onlyAfter;
        if (comparison.whyNot.empty())
            comparison.whyNot = pair.after.estimate ? pair.before.whyNone : pair.after.whyNone;
    }
    if (judged.empty())
        return fileError(plan.data,
                         Message(TR_NOOP("core", "no scene that both models can estimate: %1; "
                                                 "choose another file of scenes"),
                                 comparison.whyNot));
    comparison.scenes = judged.size();
    comparison.oldTrained = trainingScenes(judged, (*before)->model.data);
    comparison.newTrained = trainingScenes(judged, (*after)->model.data);
    comparison.before = summaryOf(ofBefore);
    comparison.after = summaryOf(ofAfter);
    comparison.nearDifference = differenceOf(ofBefore, ofAfter, scenes, plan.settings.seed);
    return comparison;
}

}  // namespace terratact
