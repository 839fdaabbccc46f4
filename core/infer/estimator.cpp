#include "core/infer/estimator.h"

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

}  // namespace

Models::Models(const ModelData& model, const RobotModel& robot)
    : pa(model, FeatureSet::Pa), paf(model, FeatureSet::Paf), clearance(model),
      conditionals(conditionalsOf(model, robot))
{
}

SceneSampling sceneSampling(const Proprioception& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const Models& models, const Settings& settings,
                            const Watch& watch, const WeakHeights& weak)
{
    if (settings.method == Method::Clearance)
        return clearanceSampling(s, arm, robot, models.conditionals, settings, watch, weak);
    if (weak != WeakHeights{})
        throw std::invalid_argument("the paper's methods take no weak heights");
    return paperSampling(s, arm, robot, usesForces(settings.method) ? models.paf : models.pa,
                         settings, watch);
}

TerrainEstimate estimateTerrain(const Proprioception& s, std::span<const ArmReading> arm,
                                const RobotModel& robot, const Models& models,
                                const Settings& settings, const Watch& watch,
                                const WeakHeights& weak)
{
    if (isClosedForm(settings.method))
        return reconstructClosedForm(s, arm, robot, models.clearance, settings, weak,
                                     pollOf(watch));
    return sampleScene(sceneSampling(s, arm, robot, models, settings, watch, weak), watch);
}

}  // namespace terratact
