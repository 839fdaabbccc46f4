#include <fmt/core.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/modelling/simulation/simulated_scenes.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/store/file_group.h"

namespace terratact {

namespace {

/// Writes a recording that `text` makes to a file, and says so.
template <class AnyScene>
Status writeRecording(const Result<DrivenScenes<AnyScene>>& recording, const RobotModel& robot,
                      const SimulateOptions& options,
                      std::string (*text)(const std::vector<AnyScene>&))
{
    if (!recording) return recording.error();
    if (recording->scenes.empty())
        return Error{
            fmt::format("{}: the robot finds no rest pose anywhere on it", options.scenes.terrain),
            0};
    FileGroup files;
    std::size_t points = 0;
    if (recording->map.isWanted()) {
        const auto made = recording->map.write(robot, files);
        if (!made) return made.error();
        points = *made;
    }
    if (Status written = writeTogether(files, options.out, text(recording->scenes)); !written)
        return written;
    std::FILE* const messages = messagesBeside(options.out);
    printText(messages, "{} scenes over {} written to {}", recording->scenes.size(),
              options.scenes.terrain, options.out);
    if (recording->skipped > 0)
        printText(messages, " ({} stops left out: no rest pose)", recording->skipped);
    printText(messages, "\n");
    if (!recording->map.isWanted()) return Done{};
    printText(messages, "{} points written to {}, poses to {}\n", points, options.scenes.map.cloud,
              options.scenes.map.poses);
    return Done{};
}

}  // namespace

Status simulate(const SimulateOptions& options)
{
    const auto robot = readRobotModel(options.robot);
    if (!robot) return robot.error();
    if (options.tracks)
        return writeRecording(simulateTrackScenes(*robot, options.scenes), *robot, options,
                              twoTrackScenesText);
    return writeRecording(simulateScenes(*robot, options.scenes), *robot, options, scenesText);
}

}  // namespace terratact
