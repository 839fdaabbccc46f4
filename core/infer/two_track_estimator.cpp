#include "core/infer/two_track_estimator.h"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/infer/closed_form_parts.h"
#include "core/infer/estimate/missing_sensors.h"
#include "core/learn/data/side_features.h"
#include "core/robot/side_plane.h"

namespace terratact {

namespace {

constexpr double kTurned = 0.02;  // [rad] of a differential, beyond its sensor's noise

void requireSides(const TwoTrackReadings& s, const Models& models)
{
    if (!models.sides)
        throw RefusedInput(TR_NOOP("core", "the model has learnt one plane only: `terratact train "
                                           "--tracks` makes one for two tracks"));
    if (std::abs(s.differential.value_or(0.0)) > kTurned)
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

void writeMissing(TerrainEstimate& estimate, const Proprioception& own)
{
    const Method method = estimate.settings.method;
    estimate.missing = missingFor(method, own);
    const std::vector<Message> sentences = missingSentences(method, estimate.missing);
    estimate.warnings.insert(estimate.warnings.begin(), sentences.begin(), sentences.end());
}

}  // namespace

TwoTrackEstimate estimateByBothSides(const TwoTrackReadings& s, const SideArms& arms,
                                     const RobotModel& robot, const Models& models,
                                     const Settings& settings, const Watch& watch)
{
    requireClosedForm(settings);
    requireSides(s, models);
    const Poll poll = pollOf(watch);
    const Reduced left = reducedFor(absentFeatures(s, Side::Left), models, watch, poll);
    const Reduced right = reducedFor(absentFeatures(s, Side::Right), models, watch, poll);
    const SideModels own{left ? *left : *models.sides, right ? *right : *models.sides};
    TwoTrackEstimate estimate = reconstructBothSides(s, arms, robot, own, settings, poll);
    writeMissing(estimate.side[0], sideReadings(s, Side::Left));
    writeMissing(estimate.side[1], sideReadings(s, Side::Right));
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
