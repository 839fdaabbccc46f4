#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/figures/robot_figure.h"
#include "app/modelling/robots/robot_check.h"
#include "app/modelling/robots/robot_proposal.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/store/file_read.h"

namespace terratact {

namespace {

/// Calibrates a robot file from recordings, prints the result and writes the proposed file if it is wanted.
Status calibrateFromRecordings(const RobotCheckOptions& options, const RobotModel& robot)
{
    const auto poses = standingPosesOf(options.recordings, robot);
    if (!poses) return poses.error();
    const auto calibration = calibrateRobot(robot, *poses);
    if (!calibration) return fileError(options.recordings.front(), calibration.error().text);
    std::FILE* const messages = messagesBeside(options.out);
    for (const std::string& line : calibrationReport(*calibration, robot))
        printText(messages, "{}\n", line);
    if (options.out.empty()) return Done{};
    const auto text = readFile(options.file, std::size_t{64} * 1024);
    if (!text) return text.error();
    const auto proposed = proposedRobotFile(options.file, *text, *calibration);
    if (!proposed) return proposed.error();
    if (Status done = writeText(options.out, *proposed); !done) return done;
    printText(messages, "proposed robot file written to {}; check it before you use it\n",
              options.out);
    return Done{};
}

}  // namespace

Status checkRobotFiles(const RobotCheckOptions& options)
{
    const auto check = checkRobotFile(options.file);
    if (!check) return check.error();
    std::FILE* const messages = messagesBeside(options.out);
    if (!options.picture.empty()) {
        if (Status drawn = writeRobotFigure(options.picture, check->robot); !drawn) return drawn;
        printText(messages, "drawn in {}\n", options.picture);
    }
    for (const RobotFinding& finding : check->findings)
        printText(messages, "{:<8} {}\n",
                  finding.level == RobotFinding::Level::Problem ? "problem" : "remark",
                  finding.text);
    const std::size_t problems = check->problems();
    if (problems > 0)
        return fileError(options.file, fmt::format("cannot be a robot: {} problem{}, see above",
                                                   problems, problems == 1 ? "" : "s"));
    printText(messages, "{}: {} remark{}, no problem\n", options.file, check->findings.size(),
              check->findings.size() == 1 ? "" : "s");
    return options.recordings.empty() ? Status(Done{})
                                      : calibrateFromRecordings(options, check->robot);
}

}  // namespace terratact
