#include "core/infer/trail_form.h"

#include <algorithm>

#include "core/infer/closed_form_parts.h"
#include "core/learn/data/side_features.h"
#include "core/terrain/body_ceiling.h"
#include "core/trail/trail_inputs.h"

namespace terratact {
namespace {

constexpr SourceText kForgotten =
    TR_NOOP("core", "nothing of the way is remembered: this scene alone counts");
constexpr SourceText kArmAlone =
    TR_NOOP("core", "of the way, only the arm's earlier readings are used");

bool hasWay(const TrailHistory* history)
{
    return history && isUsable(*history);
}

EarlierTouch armOn(const TrailGround& ground)
{
    EarlierTouch earlier;
    for (std::size_t i = 0; i < kBins; ++i)
        if (ground.armSd[i] > 0.0)
            earlier.arm[i] = MeasuredHeight{ground.armHeight[i], ground.armSd[i], Origin::Sampled};
    return earlier;
}

EarlierTouch earlierOn(const TrailGround& ground)
{
    EarlierTouch earlier = armOn(ground);
    earlier.felt = ground.felt;
    return earlier;
}

GaussianMixture distributionOf(const TrailPrediction& prediction)
{
    return smoothed(prediction.mean, prediction.errors);
}

}  // namespace

bool remembers(const Models& models, const TrailHistory* history, const RobotModel& robot,
               const Proprioception& s)
{
    return models.trail && hasWay(history) && models.trail->knowsPlane(coveredAt(robot, s));
}

bool remembers(const Models& models, const TrailHistory* history, const RobotModel& robot,
               const TwoTrackReadings& s)
{
    return models.trail && hasWay(history) && models.trail->knowsSides(coveredOnSides(robot, s));
}

TerrainEstimate trailEstimate(const Proprioception& s, const TrailHistory& history,
                              std::span<const ArmReading> arm, const RobotModel& robot,
                              const Models& models, const Settings& settings, const Poll& poll)
{
    requireClosedForm(settings);
    callPoll(poll);
    const Heights ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);
    const Eigen::VectorXd inputs = planeInputs(s, history, ceiling);
    return estimateFrom({distributionOf(models.trail->plane(inputs, coveredBins(ceiling))),
                         {},
                         models.clearance.novelty(knownFeatures(s)),
                         earlierOn(history.ground[0])},
                        s, arm, robot, settings, poll);
}

TwoTrackEstimate trailEstimate(const TwoTrackReadings& s, const TrailHistory& history,
                               const SideArms& arms, const RobotModel& robot, const Models& models,
                               const Settings& settings, const Poll& poll)
{
    requireClosedForm(settings);
    callPoll(poll);
    const std::array<Eigen::VectorXd, 2> inputs{
        sideInputs(s, Side::Left, history, sideCeiling(robot, s, Side::Left)),
        sideInputs(s, Side::Right, history, sideCeiling(robot, s, Side::Right))};
    return estimateFrom({distributionOf(models.trail->sides(inputs, coveredOnSides(robot, s))),
                         {},
                         models.sides->novelty(sideFeatures(s, Side::Left)),
                         {earlierOn(history.ground[1]), earlierOn(history.ground[2])}},
                        s, arms, robot, settings, poll);
}

EarlierTouch earlierArm(const TrailHistory* history, std::size_t plane)
{
    return hasWay(history) ? armOn(history->ground.at(plane)) : EarlierTouch{};
}

bool usesEarlierArm(const TerrainEstimate& estimate, const EarlierTouch& earlier)
{
    for (std::size_t i = 0; i < kBins; ++i)
        if (earlier.arm[i] && estimate.origin[i] == Origin::Sampled) return true;
    return false;
}

void warnForgotten(TerrainEstimate& estimate, const EarlierTouch& earlier)
{
    estimate.warnings.emplace_back(usesEarlierArm(estimate, earlier) ? kArmAlone : kForgotten);
}

bool isForgotten(const TerrainEstimate& estimate)
{
    return std::ranges::any_of(estimate.warnings, [](const Message& warning) {
        return warning.source == kForgotten.english || warning.source == kArmAlone.english;
    });
}

}  // namespace terratact
