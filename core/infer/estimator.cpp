#include "core/infer/estimator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/infer/closed_form.h"
#include "core/infer/reconstruct.h"
#include "core/infer/reconstruct_clearance.h"

namespace terratact {

namespace {

ClearanceConditionals conditionalsOf(const ModelData& model, const RobotModel& robot)
{
    ClearanceTraining training = clearanceTraining(model, robot);
    ClearanceConditionalData data = clearanceConditionalData(model, training);
    return {std::move(training), std::move(data)};
}

TerrainEstimate estimateBy(const Proprioception& s, std::span<const ArmReading> arm,
                           const RobotModel& robot, const Models& models, const Settings& settings,
                           const Watch& watch)
{
    if (isClosedForm(settings.method))
        return reconstructClosedForm(s, arm, robot, models.clearance, settings);
    if (settings.method == Method::Clearance)
        return reconstructClearance(s, arm, robot, models.conditionals, settings, watch);
    return reconstruct(s, arm, robot, usesForces(settings.method) ? models.paf : models.pa,
                       settings, watch);
}

bool allFinite(const Heights& values)
{
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

bool isFinite(const TerrainEstimate& e)
{
    return allFinite(e.mean) && allFinite(e.sd) && allFinite(e.q10) && allFinite(e.q90)
        && allFinite(e.height) && allFinite(e.rhat) && allFinite(e.ess) && std::isfinite(e.novelty)
        && std::all_of(e.draws.begin(), e.draws.end(), allFinite);
}

}  // namespace

Models::Models(const ModelData& model, const RobotModel& robot)
    : pa(model, FeatureSet::Pa), paf(model, FeatureSet::Paf), clearance(model),
      conditionals(conditionalsOf(model, robot))
{
}

TerrainEstimate estimateTerrain(const Proprioception& s, std::span<const ArmReading> arm,
                                const RobotModel& robot, const Models& models,
                                const Settings& settings, const Watch& watch)
{
    stopIfCancelled(watch);
    TerrainEstimate estimate = estimateBy(s, arm, robot, models, settings, watch);
    if (!isFinite(estimate))
        throw std::invalid_argument("the model gives no finite estimate of this scene");
    return estimate;
}

}  // namespace terratact
