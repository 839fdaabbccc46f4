#include "app/recording/session_scenes.h"

#include <algorithm>

#include "app/recording/session_text.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/two_track_estimator.h"
#include "core/infer/two_track_form.h"
#include "core/robot/force_sensor.h"
#include "core/sim/drive.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {
namespace {

/// Readings of the arm in a scene, and the settings of its last estimate.
struct SceneTouches {
    std::vector<ArmReading> readings{};
    Settings settings{};
};

SceneTouches lastTouches(const SessionReader& session, const SceneRow& row)
{
    SceneTouches touches;
    for (const EstimateRow& estimate : session.estimates())
        if (estimate.scene == row.id)
            touches = {estimate.readings, estimate.estimate.side[0].settings};
    return touches;
}

/// Returns the heights that were touched.
OptionalHeights touchedHeights(const MeasuredBins& measured)
{
    OptionalHeights heights;
    for (std::size_t i = 0; i < kBins; ++i)
        if (measured.bin[i]) heights[i] = measured.bin[i]->height;
    return heights;
}

Scene planeScene(const SessionReader& session, const RobotModel* robot, const SceneRow& row)
{
    Scene scene{.run = driveName(session.path()),
                .time = secondsOf(row.time),
                .s = proprioception(row.measurement),
                .truth = {}};
    if (row.truth) {
        scene.truth = known(*row.truth);
    } else if (robot) {
        const SceneTouches touches = lastTouches(session, row);
        const Heights ceiling = bodyCeiling(*robot, scene.s.pitch, scene.s.front, scene.s.rear);
        scene.truth = touchedHeights(
            measureBins(*robot, scene.s, touches.readings, ceiling, touches.settings));
    }
    return scene;
}

MeasuredBins touchedOnSide(Side side, const TwoTrackReadings& s, const RobotModel& robot,
                           SceneTouches touches)
{
    const ProbeSide own = side == Side::Left ? ProbeSide::Left : ProbeSide::Right;
    std::erase_if(touches.readings, [own](const ArmReading& r) { return r.side != own; });
    return measuredOnSide(side, s, touches.readings, robot, sideCeiling(robot, s, side),
                          touches.settings);
}

TwoTrackScene sidesScene(const SessionReader& session, const RobotModel* robot, const SceneRow& row)
{
    if (!hasSides(row.measurement)) return onBothSides(planeScene(session, robot, row));
    TwoTrackScene scene{.run = driveName(session.path()),
                        .time = secondsOf(row.time),
                        .s = twoTrackReadings(row.measurement),
                        .truth = {}};
    for (const Side side : {Side::Left, Side::Right}) {
        OptionalHeights& truth = scene.truth.at(indexOf(side));
        if (row.sideTruth)
            truth = known(row.sideTruth->at(indexOf(side)));
        else if (robot)
            truth = touchedHeights(touchedOnSide(side, scene.s, *robot, lastTouches(session, row)));
    }
    return scene;
}

std::size_t countKnown(const OptionalHeights& truth)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(truth, [](const auto& height) { return height.has_value(); }));
}

}  // namespace

void addSessionScenes(const SessionReader& session, const std::set<std::int64_t>& repeated,
                      const RobotModel* robot, std::vector<Scene>& scenes)
{
    for (const SceneRow& row : session.scenes())
        if (!repeated.contains(row.id)) scenes.push_back(planeScene(session, robot, row));
}

void addSessionScenes(const SessionReader& session, const std::set<std::int64_t>& repeated,
                      const RobotModel* robot, std::vector<TwoTrackScene>& scenes)
{
    for (const SceneRow& row : session.scenes())
        if (!repeated.contains(row.id)) scenes.push_back(sidesScene(session, robot, row));
}

std::size_t countKnownHeights(const Scene& scene)
{
    return countKnown(scene.truth);
}

std::size_t countKnownHeights(const TwoTrackScene& scene)
{
    return countKnown(scene.truth[0]) + countKnown(scene.truth[1]);
}

}  // namespace terratact
