#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>

#include "app/cli/session/open_session.h"
#include "app/cli/session/session_commands.h"
#include "app/recording/scene_origins.h"
#include "app/recording/session_drive.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/base/text.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/two_track_estimator.h"
#include "core/infer/two_track_form.h"
#include "core/learn/data/drive_file.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/log/session_reader.h"
#include "core/store/file_read.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {

namespace {

/// Readings of the arm in a scene, and the settings of its last estimate.
struct Touches {
    std::vector<ArmReading> readings{};
    Settings settings{};
};

Touches touchesOf(const SessionReader& session, const SceneRow& row)
{
    Touches touches;
    for (const EstimateRow& estimate : session.estimates())
        if (estimate.scene == row.id)
            touches = {estimate.readings, estimate.estimate.side[0].settings};
    return touches;
}

OptionalHeights known(const Heights& heights)
{
    OptionalHeights all;
    std::ranges::copy(heights, all.begin());
    return all;
}

/// Returns heights that were touched, by the rules of the methods. If flipper and arm touched a bin, the arm's height
/// counts.
OptionalHeights heightsOf(const MeasuredBins& measured)
{
    OptionalHeights heights;
    for (std::size_t i = 0; i < kBins; ++i)
        if (measured.bin[i]) heights[i] = measured.bin[i]->height;
    return heights;
}

/// Converts scenes of one session. robot: for heights that were touched; null: only the truth is wanted.
struct Converter {
    const SessionReader& session;
    const RobotModel* robot;

    void add(const SceneRow& row, std::vector<Scene>& scenes) const
    {
        scenes.push_back(ofOnePlane(row));
    }

    void add(const SceneRow& row, std::vector<TwoTrackScene>& scenes) const
    {
        if (!hasSides(row.measurement)) return scenes.push_back(onBothSides(ofOnePlane(row)));
        TwoTrackScene scene{.run = driveName(session.path()),
                            .time = secondsOf(row.time),
                            .s = twoTrackReadings(row.measurement),
                            .truth = {}};
        for (const Side side : {Side::Left, Side::Right}) {
            const std::size_t k = side == Side::Left ? 0 : 1;
            if (row.sideTruth)
                scene.truth.at(k) = known(row.sideTruth->at(k));
            else if (robot)
                scene.truth.at(k) = heightsOf(touchedOn(side, scene.s, row));
        }
        scenes.push_back(std::move(scene));
    }

private:
    Scene ofOnePlane(const SceneRow& row) const
    {
        Scene scene{.run = driveName(session.path()),
                    .time = secondsOf(row.time),
                    .s = proprioception(row.measurement),
                    .truth = {}};
        if (row.truth) {
            scene.truth = known(*row.truth);
        } else if (robot) {
            const Touches touches = touchesOf(session, row);
            const Heights ceiling = bodyCeiling(*robot, scene.s.pitch, scene.s.front, scene.s.rear);
            scene.truth = heightsOf(
                measureBins(*robot, scene.s, touches.readings, ceiling, touches.settings));
        }
        return scene;
    }

    MeasuredBins touchedOn(Side side, const TwoTrackReadings& s, const SceneRow& row) const
    {
        Touches touches = touchesOf(session, row);
        const ProbeSide own = side == Side::Left ? ProbeSide::Left : ProbeSide::Right;
        std::erase_if(touches.readings, [own](const ArmReading& r) { return r.side != own; });
        return measuredOnSide(side, s, touches.readings, *robot, sideCeiling(*robot, s, side),
                              touches.settings);
    }
};

template <class Scenes>
Status addScenes(const std::string& path, bool measured, SceneOrigins& origins, Scenes& scenes)
{
    const auto session = openSession(path);
    if (!session) return session.error();
    const auto robot = robotOf(*session);
    if (measured && !robot) return robot.error();
    const std::set<std::int64_t> repeated = origins.add(*session);
    const Converter converter{*session, measured ? &*robot : nullptr};
    for (const SceneRow& row : session->scenes())
        if (!repeated.contains(row.id)) converter.add(row, scenes);
    for (const SessionDamage& damage : session->damage())
        printText(stderr, "terratact: {}: left out: {}\n", path,
                  damageText(session->start(), damage));
    return Done{};
}

std::size_t knownHeights(const OptionalHeights& truth)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(truth, [](const auto& height) { return height.has_value(); }));
}
std::size_t knownHeights(const Scene& scene)
{
    return knownHeights(scene.truth);
}
std::size_t knownHeights(const TwoTrackScene& scene)
{
    return knownHeights(scene.truth[0]) + knownHeights(scene.truth[1]);
}

template <class Scenes, class Text>
Status exportAs(const SessionScenesOptions& options, Scenes scenes, Text text)
{
    SceneOrigins origins;
    for (const std::string& file : options.files)
        if (Status added = addScenes(file, options.measured, origins, scenes); !added) return added;
    if (scenes.empty()) return Error{options.files.front() + ": no scene was captured"};
    if (Status written = writeText(options.out, text(scenes)); !written) return written;
    std::size_t heights = 0;
    for (const auto& scene : scenes) heights += knownHeights(scene);
    printText(messagesBeside(options.out), "{} scenes with {} known heights written to {}\n",
              scenes.size(), heights, options.out);
    return Done{};
}

/// Scenes of one plane hold the means of both sides.
void printUnusedSides(const std::vector<std::string>& files)
{
    std::ptrdiff_t withSides = 0;
    for (const std::string& file : files)
        if (const auto session = openSession(file))
            withSides += std::ranges::count_if(
                session->scenes(), [](const SceneRow& row) { return hasSides(row.measurement); });
    if (withSides > 0)
        printText(stderr,
                  "terratact: left and right are known in {} scenes, whose means were written: "
                  "session scenes --tracks writes both sides\n",
                  withSides);
}

Status exportDrives(const SessionScenesOptions& options)
{
    std::string text = drivesHeader(!options.tracks, DriveColumns::Measured);
    std::size_t lines = 0, scenes = 0;
    std::set<std::string> runs;
    for (const std::string& file : options.files) {
        auto session = SessionReader::open(file);
        if (!session) return session.error();
        const auto robot = robotOf(*session);
        if (!robot) return robot.error();
        const auto found = sessionDrive(*session, *robot, !options.tracks);
        if (!found) return found.error();
        if (!runs.insert(found->drive.run).second)
            return fileError(file, fmt::format("its name gives the run {}, as another file's does: "
                                               "rename one of them",
                                               shown(found->drive.run)));
        if (found->leftOut > 0)
            printText(stderr,
                      "terratact: {}: {} lines beyond the ranges of their columns left out\n", file,
                      found->leftOut);
        text += driveText(found->drive, DriveColumns::Measured);
        lines += found->drive.lines.size() - found->scenes;
        scenes += found->scenes;
    }
    if (Status written = writeText(options.out, text); !written) return written;
    printText(messagesBeside(options.out),
              "{} lines of the way and {} scenes of {} drives written to {}\n", lines, scenes,
              options.files.size(), options.out);
    return Done{};
}

}  // namespace

Status exportScenes(const SessionScenesOptions& options)
{
    if (options.drives) return exportDrives(options);
    if (options.tracks) return exportAs(options, std::vector<TwoTrackScene>{}, twoTrackScenesText);
    const Status done = exportAs(options, std::vector<Scene>{}, scenesText);
    if (done) printUnusedSides(options.files);
    return done;
}

}  // namespace terratact
