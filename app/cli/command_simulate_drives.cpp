#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/modelling/simulation/simulated_drives.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/base/degree.h"

namespace terratact {
namespace {

SimulatedDrives wantedDrives(const SimulateOptions& options)
{
    SimulatedDrives drives{.grounds = {.terrain = options.scenes.terrain,
                                       .step = options.scenes.step,
                                       .blocks = options.scenes.blocks,
                                       .seed = options.scenes.seed},
                           .drives = options.drives,
                           .tracks = options.tracks,
                           .way = options.way,
                           .softDrives = options.scenes.softDrives,
                           .exactTruth = options.scenes.exactTruth};
    drives.way.pitchBias = options.pitchBiasDegrees * kDegree;
    return drives;
}

Status writeParts(const std::string& path, const std::vector<std::string>& parts)
{
    Result<TextOutput> out = TextOutput::begin(path);
    if (!out) return out.error();
    for (const std::string& part : parts) out->stream() << part;
    return out->commit();
}

}  // namespace

Status recordDrives(const SimulateOptions& options)
{
    const auto robot = readRobotModel(options.robot);
    if (!robot) return robot.error();
    const auto recording = simulateDrives(*robot, wantedDrives(options));
    if (!recording) return recording.error();
    if (recording->lines == 0)
        return Error{
            fmt::format("{}: the robot finds no rest pose anywhere on it", options.scenes.terrain),
            0};
    if (Status written = writeParts(options.out, recording->parts); !written) return written;
    std::FILE* const messages = messagesBeside(options.out);
    printText(messages, "{} drives over {} with {} lines and {} scenes written to {}",
              recording->drives, options.scenes.terrain, recording->lines, recording->scenes,
              options.out);
    if (recording->skipped > 0)
        printText(messages, " ({} stops left out: no rest pose)", recording->skipped);
    printText(messages, "\n");
    return Done{};
}

}  // namespace terratact
