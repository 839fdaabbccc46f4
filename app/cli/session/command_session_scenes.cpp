#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "app/cli/session/open_session.h"
#include "app/cli/session/session_commands.h"
#include "app/recording/scene_origins.h"
#include "app/recording/session_drive.h"
#include "app/recording/session_scenes.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/base/text.h"
#include "core/infer/two_track_estimator.h"
#include "core/learn/data/drive_file.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/log/session_reader.h"
#include "core/store/file_read.h"

namespace terratact {

namespace {

template <class Scenes>
Status addScenes(const std::string& path, bool measured, SceneOrigins& origins, Scenes& scenes)
{
    const auto session = openSession(path);
    if (!session) return session.error();
    const auto robot = robotOf(*session);
    if (measured && !robot) return robot.error();
    const std::set<std::int64_t> repeated = origins.add(*session);
    addSessionScenes(*session, repeated, measured ? &*robot : nullptr, scenes);
    for (const SessionDamage& damage : session->damage())
        printText(stderr, "terratact: {}: left out: {}\n", path,
                  damageText(session->start(), damage));
    return Done{};
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
    for (const auto& scene : scenes) heights += countKnownHeights(scene);
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
    SceneOrigins origins;
    for (const std::string& file : options.files) {
        auto session = SessionReader::open(file);
        if (!session) return session.error();
        const auto robot = robotOf(*session);
        if (!robot) return robot.error();
        const std::set<std::int64_t> repeated = origins.add(*session);
        if (!repeated.empty() && repeated.size() == session->scenes().size()) continue;
        const auto found = sessionDrive(*session, *robot, !options.tracks, repeated);
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
              runs.size(), options.out);
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
