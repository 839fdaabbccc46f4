#include "app/modelling/training/mix_judges.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "app/modelling/evaluation/two_track_evaluation.h"
#include "app/modelling/training/training_run.h"
#include "app/runtime/parallel.h"
#include "core/eval/evaluation.h"
#include "core/infer/estimator.h"
#include "core/learn/model/side_training.h"
#include "core/learn/model/training.h"

namespace terratact {
namespace {

constexpr int kRowsOfMixSearch = 300;

Settings localSettings(const TrainingPlan& plan)
{
    Settings settings;
    settings.method = Method::Local;
    settings.seed = plan.seed;
    return settings;
}

/// Returns a watch with the cancellation of another, but without progress reports.
TrainingWatch silent(const TrainingWatch& watch)
{
    TrainingWatch quiet;
    quiet.cancelled = watch.cancelled;
    return quiet;
}

/// Returns the |errors| of one scene [m]; empty if it cannot be estimated.
std::vector<double> planeErrors(const Scene& scene, const RobotModel& robot, const Models& models,
                                const Settings& settings)
{
    std::vector<double> errors;
    try {
        const TerrainEstimate estimate = estimateTerrain(scene.s, {}, robot, models, settings);
        for (std::size_t bin = 0; bin <= kLastNearBin; ++bin)
            if (scene.truth[bin])
                errors.push_back(std::abs(estimate.height[bin] - *scene.truth[bin]));
    } catch (const std::invalid_argument&) {  // left out
    }
    return errors;
}

}  // namespace

PlaneJudge::PlaneJudge(const TrainingPlan& plan, const TrainingWatch& watch)
    : plan_(plan), watch_(silent(watch))
{
}

std::vector<double> PlaneJudge::operator()(const std::vector<Scene>& learnt,
                                           const std::vector<Scene>& judged)
{
    ModelData model;
    try {
        model = prepareTraining(learnt, {.conditionalRows = plan_.conditionalRows,
                                         .scannerSd = plan_.scannerSd,
                                         .seed = plan_.seed})
                    .model;
    } catch (const std::invalid_argument&) {
        return {};
    }
    runTraining(model, plan_, watch_,
                {.parts = TrainingScope::Parts::Surfaces, .surfaceRows = kRowsOfMixSearch});
    const Models models(model, plan_.robot);
    std::vector<std::vector<double>> ofScene(judged.size());
    parallelFor(
        static_cast<int>(judged.size()),
        [&](int k) {
            const auto at = static_cast<std::size_t>(k);
            ofScene[at] = planeErrors(judged[at], plan_.robot, models, localSettings(plan_));
        },
        plan_.threads);
    std::vector<double> errors;
    for (const std::vector<double>& some : ofScene)
        errors.insert(errors.end(), some.begin(), some.end());
    return errors;
}

SideJudge::SideJudge(const ModelData& plane, const TrainingPlan& plan, const TrainingWatch& watch)
    : plan_(plan), watch_(silent(watch)), model_(plane)
{
}

std::vector<double> SideJudge::operator()(const std::vector<TwoTrackScene>& learnt,
                                          const std::vector<TwoTrackScene>& judged)
{
    try {
        model_.sides = prepareSides(learnt).rows;
    } catch (const std::invalid_argument&) {
        return {};
    }
    runTraining(model_, plan_, watch_,
                {.parts = TrainingScope::Parts::Sides, .surfaceRows = kRowsOfMixSearch});
    return sideErrors(judged, plan_.robot, Models(model_, plan_.robot), localSettings(plan_));
}

}  // namespace terratact
