#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/figures/robot_figure.h"
#include "app/modelling/robot_check.h"
#include "app/runtime/print_text.h"
#include "core/store/file_read.h"

namespace terratact {

Status checkRobotFiles(const RobotCheckOptions& options)
{
    const auto check = checkRobotFile(options.file);
    if (!check) return check.error();
    if (!options.picture.empty()) {
        if (Status drawn = writeRobotFigure(options.picture, check->robot); !drawn) return drawn;
        printText("drawn in {}\n", options.picture);
    }
    for (const RobotFinding& finding : check->findings)
        printText("{:<8} {}\n",
                  finding.level == RobotFinding::Level::Problem ? "problem" : "remark",
                  finding.text);
    const std::size_t problems = check->problems();
    if (problems > 0)
        return fileError(options.file, fmt::format("cannot be a robot: {} problem{}, see above",
                                                   problems, problems == 1 ? "" : "s"));
    printText("{}: {} remark{}, no problem\n", options.file, check->findings.size(),
              check->findings.size() == 1 ? "" : "s");
    return Done{};
}

}  // namespace terratact
