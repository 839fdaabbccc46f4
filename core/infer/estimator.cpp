#include "core/infer/estimator.h"

#include <exception>
#include <stdexcept>
#include <utility>

#include "core/infer/closed_form.h"
#include "core/infer/estimate/missing_sensors.h"
#include "core/infer/reconstruct.h"
#include "core/infer/reconstruct_clearance.h"
#include "core/infer/trail_form.h"

namespace terratact {

namespace {

ClearanceConditionals conditionalsOf(const ModelData& model, const RobotModel& robot)
{
    ClearanceTraining training = clearanceTraining(model, robot);
    ClearanceConditionalData data = clearanceConditionalData(model, training);
    return {std::move(training), std::move(data)};
}

/// Writes the missing features and their sentences. earlier: of the estimate.
void warnMissing(TerrainEstimate& estimate, Method asked, MissingFeatures missing,
                 const EarlierTouch& earlier = {})
{
    estimate.missing = missing;
    const std::vector<Message> sentences =
        missingSentences(asked, missing, usesEarlierArm(estimate, earlier));
    estimate.warnings.insert(estimate.warnings.begin(), sentences.begin(), sentences.end());
}

}  // namespace

Models::Models(const ModelData& model, const RobotModel& robot)
    : pa(model, FeatureSet::Pa), paf(model, FeatureSet::Paf), clearance(model),
      conditionals(conditionalsOf(model, robot)), reduced(model, robot)
{
    if (!model.hasSides()) return;
    sides.emplace(model.sides);
    reducedSides.emplace(model.sides, robot);
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
        } catch (const std::invalid_argument&) {  // a scene may not need this process
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
                            const Watch& watch)
{
    if (settings.method == Method::Clearance)
        return clearanceSampling(s, arm, robot, models.conditionals, settings, watch);
    const MissingFeatures missing = missingFor(settings.method, s);
    const bool paf = usesForces(settings.method) && missing.none();
    SceneSampling sampling =
        paperSampling(s, arm, robot, paf ? models.paf : models.pa, settings, watch);
    warnMissing(sampling.estimate, settings.method, missing);
    return sampling;
}

TerrainEstimate closedFormEstimate(const Proprioception& s, std::span<const ArmReading> arm,
                                   const RobotModel& robot, const Models& models,
                                   const Settings& settings, const Watch& watch,
                                   const TrailHistory* history)
{
    const Poll poll = pollOf(watch);
    const MissingFeatures missing = missingFor(settings.method, s);
    Settings own = settings;
    own.method = methodWithout(settings.method, missing);
    if (own.method == Method::Trail && remembers(models, history, robot, s))
        return trailEstimate(s, *history, arm, robot, models, settings, poll);
    const bool isForgotten = own.method == Method::Trail;
    if (isForgotten) own.method = Method::Local;
    const EarlierTouch earlier =
        settings.method == Method::Trail ? earlierArm(history, 0) : EarlierTouch{};
    const auto reduced =
        missing.any() ? models.reduced.without(missing, watch.sideBySide, poll) : nullptr;
    TerrainEstimate estimate = reconstructClosedForm(
        s, arm, robot, reduced ? *reduced : models.clearance, own, poll, earlier);
    estimate.settings = settings;
    if (isForgotten) warnForgotten(estimate, earlier);
    warnMissing(estimate, settings.method, missing, earlier);
    return estimate;
}

TerrainEstimate estimateTerrain(const Proprioception& s, std::span<const ArmReading> arm,
                                const RobotModel& robot, const Models& models,
                                const Settings& settings, const Watch& watch,
                                const TrailHistory* history)
{
    if (isClosedForm(methodWithout(settings.method, missingFor(settings.method, s))))
        return closedFormEstimate(s, arm, robot, models, settings, watch, history);
    return sampleScene(sceneSampling(s, arm, robot, models, settings, watch), watch);
}

}  // namespace terratact
