#include "app/modelling/scene_estimates.h"

#include <fmt/format.h>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <utility>

#include "app/runtime/time_budget.h"
#include "core/atem/probe/arm_choice.h"
#include "core/infer/estimate_batch.h"
#include "core/sim/posterior_check.h"
#include "core/trail/trail_file.h"

namespace terratact {

namespace {

SceneEstimate noted(TerrainEstimate estimate)
{
    std::string note = english(estimate.warnings, "; ");
    return {.estimate = std::move(estimate), .note = std::move(note)};
}

/// Returns a standard normal number: the simulated arm's error in units of its sd.
double armNoise(std::uint64_t seed)
{
    constexpr std::uint64_t kArmStream = 0x41524DULL;  // a stream separate from that of the draws
    std::seed_seq words{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                        static_cast<std::uint32_t>(kArmStream)};
    std::mt19937_64 rng(words);
    return std::normal_distribution<double>()(rng);
}

/// Shared state: scenes to estimate and their results.
struct Work {
    std::span<const Scene> scenes;
    const EstimatorBundle& bundle;
    const Settings& settings;
    double seconds;
    std::size_t atOnce;  ///< maximum scenes in progress per thread
    std::function<void()> tick;
    std::vector<SceneEstimate> estimates{scenes.size()};
    std::atomic<std::size_t> next{0};
};

/// The work of one thread.
class Estimating {
public:
    explicit Estimating(Work& work) : work_(work), batch_(work.bundle.robot, work.bundle.models) {}

    void run()
    {
        for (;;) {
            while (inWork_ < work_.atOnce && batch_.hasRoomFor(work_.settings)) {
                const std::size_t k = work_.next++;
                if (k >= work_.scenes.size()) break;
                start(k);
            }
            if (batch_.empty()) return;
            for (EstimateBatch::Ready& ready : batch_.next()) finish(std::move(ready));
        }
    }

private:
    void start(std::size_t k)
    {
        ++inWork_;
        add(k, {});
    }

    void add(std::size_t k, std::span<const ArmReading> arm)
    {
        Settings own = work_.settings;
        own.seed += k;
        try {
            batch_.add(k, work_.scenes[k].s, arm, own, endingAfter(work_.seconds));
        } catch (const NotLearnt& error) {
            leave(k, {.note = error.what(), .whyNone = error.message()});
        }
    }

    void finish(EstimateBatch::Ready ready)
    {
        const bool first =
            usesArm(work_.settings.method) && touched_.try_emplace(ready.number).second;
        if (first) return touch(ready.number, std::move(ready.estimate));
        leave(ready.number, noted(std::move(ready.estimate)));
    }

    /// Simulates the arm if a probe is worthwhile.
    void touch(std::size_t k, TerrainEstimate first)
    {
        const std::optional<int> bin = proposeProbe(first, work_.bundle.robot);
        if (!bin) return leave(k, noted(std::move(first)));
        if (const auto truth = work_.scenes[k].truth[static_cast<std::size_t>(*bin)]) {
            const double sd = work_.bundle.robot.armSd;
            touched_[k] = {{*bin, *truth + sd * armNoise(work_.settings.seed + k), sd}};
            return add(k, touched_[k]);
        }
        first.warnings.emplace_back(
            TR_NOOP("core", "arm not simulated: the truth of bin %1 m is unknown"),
            signedFixed(binCentre(*bin), 1));
        leave(k, noted(std::move(first)));
    }

    void leave(std::size_t k, SceneEstimate estimate)
    {
        const auto touched = touched_.find(k);
        if (touched != touched_.end()) estimate.arm = touched->second;
        work_.estimates[k] = std::move(estimate);
        --inWork_;
        if (work_.tick) work_.tick();
    }

    Work& work_;
    EstimateBatch batch_;
    std::size_t inWork_ = 0;
    std::map<std::size_t, std::vector<ArmReading>>
        touched_;  // scenes whose arm was already simulated
};

/// Returns how many scenes a thread may have in progress. A time limit assumes that a scene has the thread alone. A
/// small number of scenes is spread over the threads.
std::size_t scenesAtOnce(std::size_t scenes, int threads, double seconds)
{
    const auto each = static_cast<std::size_t>(threads);
    return seconds > 0.0 ? 1 : (scenes + each - 1) / each;
}

}  // namespace

Result<std::unique_ptr<EstimatorBundle>> openEstimatorBundle(const std::string& robotPath,
                                                             const std::string& modelPath,
                                                             const std::string& trailPath)
{
    auto robot = readRobotModel(robotPath);
    if (!robot) return robot.error();
    return openEstimatorBundle(*robot, modelPath, trailPath);
}

Result<std::unique_ptr<EstimatorBundle>> openEstimatorBundle(const RobotModel& robot,
                                                             const std::string& modelPath,
                                                             const std::string& trailPath)
{
    auto model = readModel(modelPath);
    if (!model) return model.error();
    auto bundle = std::make_unique<EstimatorBundle>(robot, std::move(*model));
    if (trailPath.empty()) return bundle;
    auto trail = readTrail(trailPath);
    if (!trail) return trail.error();
    bundle->models.trail = std::make_shared<const TrailModel>(std::move(trail->data));
    return bundle;
}

TerrainEstimate estimateWith(const Scene& scene, std::span<const ArmReading> arm,
                             const EstimatorBundle& bundle, const Settings& settings,
                             double seconds)
{
    return estimateTerrain(scene.s, arm, bundle.robot, bundle.models, settings,
                           endingAfter(seconds));
}

SceneEstimate estimateScene(const Scene& scene, const EstimatorBundle& bundle,
                            const Settings& settings, double seconds)
{
    Work work{{&scene, 1}, bundle, settings, seconds, 1, {}};
    Estimating(work).run();
    return std::move(work.estimates.front());
}

Progress sceneProgress(Method method, std::size_t scenes)
{
    return {fmt::format("{}: scene", name(method)), static_cast<int>(scenes)};
}

std::vector<SceneEstimate> estimateScenes(std::span<const Scene> scenes,
                                          const EstimatorBundle& bundle, const Settings& settings,
                                          double seconds)
{
    Progress progress = sceneProgress(settings.method, scenes.size());
    return estimateScenes(scenes, bundle, settings, seconds, progress);
}

std::vector<SceneEstimate> estimateScenes(std::span<const Scene> scenes,
                                          const EstimatorBundle& bundle, const Settings& settings,
                                          double seconds, Progress& progress)
{
    const int threads = processors();
    Work work{scenes,
              bundle,
              settings,
              seconds,
              scenesAtOnce(scenes.size(), threads, seconds),
              [&progress] { progress.tick(); }};
    parallelFor(threads, [&work](int) {
        try {
            Estimating(work).run();
        } catch (...) {
            work.next = work.scenes.size();  // gives the other threads no more scenes
            throw;
        }
    });
    return std::move(work.estimates);
}

std::size_t checkEstimates(std::span<const Scene> scenes, const RobotModel& robot,
                           std::vector<SceneEstimate>& estimates)
{
    std::atomic<std::size_t> contradicting{0};
    parallelFor(static_cast<int>(scenes.size()), [&](int n) {
        const auto k = static_cast<std::size_t>(n);
        auto& estimate = estimates.at(k).estimate;
        if (!estimate) return;
        writePosteriorCheck(*estimate, scenes[k].s, robot);
        if (!estimate->contradicts) return;
        ++contradicting;
        estimates[k].note = english(estimate->warnings, "; ");
    });
    return contradicting;
}

}  // namespace terratact
