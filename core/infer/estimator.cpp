#include "core/infer/estimator.h"

#include <exception>
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

void makeProcesses(const Models& models, const Settings& settings, const Watch& watch)
{
    if (isClosedForm(settings.method)) return;
    const Poll poll = pollOf(watch);
    std::exception_ptr refused;
    const auto make = [&](auto process) {
        try {
            const GaussianProcess& gp = process();
            gp.prepare(settings.precision, poll);
        } catch (const std::invalid_argument&) {  // a scene may do without
            refused = std::current_exception();
        }
    };
    const BinModels& bins = usesForces(settings.method) ? models.paf : models.pa;
    for (int bin = 0; bin < kBins; ++bin) {
        if (settings.method != Method::Clearance)
            make([&]() -> decltype(auto) { return bins.bin(bin, settings.inducing, poll); });
        else
            for (const Regime regime : kRegimes)
                if (models.conditionals.isTrained(bin, regime))
                    make([&]() -> decltype(auto) {
                        return models.conditionals.gp(bin, regime, settings.inducing, poll);
                    });
    }
    if (refused) std::rethrow_exception(refused);
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
