#include "core/infer/two_track_estimator.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/infer/closed_form_parts.h"
#include "core/infer/each_side.h"
#include "core/infer/estimate/missing_sensors.h"
#include "core/infer/reconstruct.h"
#include "core/infer/trail_form.h"
#include "core/learn/data/side_features.h"
#include "core/robot/side_plane.h"
#include "core/robot/watch/sensor.h"

namespace terratact {

namespace {

void requireSides(const TwoTrackReadings& s, const Models& models)
{
    if (!models.sides)
        throw RefusedInput(TR_NOOP("core", "the model has learnt one plane only: `terratact train "
                                           "--tracks` makes one for two tracks"));
    if (hasTurned(s.differential))
        throw RefusedInput(TR_NOOP(
            "core", "the track differential has turned: estimates of both sides need it locked"));
}

/// Model without the features that one side's processes lack; empty: the whole model serves.
using Reduced = std::shared_ptr<const ClearanceModel>;

Reduced reducedFor(const AbsentFeatures& absent, const Models& models, const Watch& watch,
                   const Poll& poll)
{
    return absent.any() ? models.reducedSides->without(absent, watch.sideBySide, poll) : nullptr;
}

/// Writes the missing features and their sentences. own: readings of the side; earlier: of the estimate.
void writeMissing(TerrainEstimate& estimate, const Proprioception& own, const EarlierTouch& earlier)
{
    const Method method = estimate.settings.method;
    estimate.missing = missingFor(method, own);
    const std::vector<Message> sentences =
        missingSentences(method, estimate.missing, usesEarlierArm(estimate, earlier));
    estimate.warnings.insert(estimate.warnings.begin(), sentences.begin(), sentences.end());
}

void warnBoth(TwoTrackEstimate& estimate, const Message& sentence)
{
    for (TerrainEstimate& side : estimate.side) side.warnings.push_back(sentence);
}

/// Warns about forces that one side lacks: the plane has those of the other side.
void warnOfOneSide(TerrainEstimate& plane, const Measurement& line)
{
    const TwoTrackReadings s = twoTrackReadings(line);
    const auto missingOf = [&](Side side) {
        return missingFor(plane.settings.method, sideReadings(s, side));
    };
    const MissingFeatures left = missingOf(Side::Left), right = missingOf(Side::Right);
    std::ranges::move(ofBothSides(oneSidedSentences(left, right), oneSidedSentences(right, left)),
                      std::back_inserter(plane.warnings));
}

/// Warns of each current that only the other side of its axle measured.
void warnOfMotors(TerrainEstimate& plane, const Measurement& line)
{
    if (!usesForces(plane.settings.method)) return;
    for (std::size_t motor = 0; motor < kMotors; ++motor)
        if (line.missingMotors[motor])
            plane.warnings.emplace_back(
                TR_NOOP("core", "the %1 was not measured: the other side counts for both"),
                describe(sensorAt(indexOf(Sensor::FrontLeftCurrent) + motor)));
}

TwoTrackEstimate asOnePlane(const Measurement& line, std::span<const ArmReading> readings,
                            const RobotModel& robot, const Models& models, const Settings& settings,
                            const Watch& watch, const TrailHistory* history)
{
    TerrainEstimate plane =
        estimateTerrain(proprioception(line), readings, robot, models, settings, watch, history);
    warnOfOneSide(plane, line);
    warnIfNotPlanar(plane, line);
    warnOfMotors(plane, line);
    return equalSides(std::move(plane));
}

std::vector<ArmReading> readingsOn(ProbeSide side, std::span<const ArmReading> readings)
{
    std::vector<ArmReading> own;
    std::ranges::copy_if(readings, std::back_inserter(own),
                         [side](const ArmReading& reading) { return reading.side == side; });
    return own;
}

/// Warns about a scene whose sides differ, and that the method estimates as one plane nevertheless.
void warnOfMethod(TwoTrackEstimate& estimate, Method method)
{
    warnBoth(estimate, Message(TR_NOOP("core", "method %1 estimates left and right as one plane, "
                                               "although they differ"),
                               name(method)));
}

}  // namespace

bool hasSides(const Measurement& line)
{
    for (std::size_t e = 0; e < std::size_t{kForceElements}; ++e)
        if (!line.missing[kFirstForceFeature + e] && !line.sides.knows(e)) return false;
    return true;
}

bool allowsBothSides(const Measurement& line, Method method)
{
    return hasSides(line) && (isClosedForm(method) || method == Method::Clearance)
        && !hasTurned(line.differential);
}

TwoTrackEstimate estimateMeasured(const Measurement& line, std::span<const ArmReading> readings,
                                  const RobotModel& robot, const Models& models,
                                  const Settings& settings, const Watch& watch,
                                  const TrailHistory* history)
{
    const TwoTrackReadings s = twoTrackReadings(line);
    const std::vector<ArmReading> left = readingsOn(ProbeSide::Left, readings),
                                  right = readingsOn(ProbeSide::Right, readings);
    const bool hasArms = !left.empty() || !right.empty();
    if (!models.sides || !hasSides(line) || (!hasArms && isSymmetric(s)))
        return asOnePlane(line, readings, robot, models, settings, watch, history);
    if (!allowsBothSides(line, settings.method)) {
        TwoTrackEstimate plane =
            asOnePlane(line, readings, robot, models, settings, watch, history);
        if (!hasTurned(line.differential) && (hasArms || sidesDiffer(s)))
            warnOfMethod(plane, settings.method);
        return plane;
    }
    TwoTrackEstimate estimate =
        isClosedForm(settings.method)
            ? estimateByBothSides(s, {left, right}, robot, models, settings, watch, history)
            : estimateEachSide(s, {left, right}, robot, models, settings, watch);
    for (const ArmReading& reading : readingsOn(ProbeSide::Middle, readings))
        warnBoth(estimate, Message(TR_NOOP("core", "the arm's reading at %1 m lies in the middle "
                                                   "and counts for neither side"),
                                   signedFixed(binCentre(reading.bin), 1)));
    return estimate;
}

TwoTrackEstimate estimateByBothSides(const TwoTrackReadings& s, const SideArms& arms,
                                     const RobotModel& robot, const Models& models,
                                     const Settings& settings, const Watch& watch,
                                     const TrailHistory* history)
{
    requireClosedForm(settings);
    requireSides(s, models);
    const Poll poll = pollOf(watch);
    const AbsentFeatures absentLeft = absentFeatures(s, Side::Left);
    const bool isTrail = settings.method == Method::Trail;
    if (isTrail && absentLeft.none() && remembers(models, history, robot, s))
        return trailEstimate(s, *history, arms, robot, models, settings, poll);
    Settings scene = settings;
    if (isTrail) scene.method = Method::Local;
    const Reduced left = reducedFor(absentLeft, models, watch, poll);
    const Reduced right = reducedFor(absentFeatures(s, Side::Right), models, watch, poll);
    const SideModels own{left ? *left : *models.sides, right ? *right : *models.sides};
    std::array<EarlierTouch, 2> earlier;
    if (isTrail) earlier = {earlierArm(history, 1), earlierArm(history, 2)};
    TwoTrackEstimate estimate = reconstructBothSides(s, arms, robot, own, scene, poll, earlier);
    for (std::size_t k = 0; k < 2; ++k) {
        estimate.side[k].settings = settings;
        if (isTrail && absentLeft.none()) warnForgotten(estimate.side[k], earlier[k]);
    }
    writeMissing(estimate.side[0], sideReadings(s, Side::Left), earlier[0]);
    writeMissing(estimate.side[1], sideReadings(s, Side::Right), earlier[1]);
    return estimate;
}

TwoTrackEstimate estimateAsOnePlane(const TwoTrackReadings& s, const RobotModel& robot,
                                    const Models& models, const Settings& settings,
                                    const Watch& watch)
{
    const TerrainEstimate plane =
        estimateTerrain(planeReadings(s), {}, robot, models, settings, watch);
    return {.side = {plane, plane}, .onePlane = true};
}

TwoTrackEstimate estimateTwoTracks(const TwoTrackReadings& s, const SideArms& arms,
                                   const RobotModel& robot, const Models& models,
                                   const Settings& settings, const Watch& watch)
{
    if (arms[0].empty() && arms[1].empty() && isSymmetric(s))
        return estimateAsOnePlane(s, robot, models, settings, watch);
    return estimateByBothSides(s, arms, robot, models, settings, watch);
}

}  // namespace terratact
