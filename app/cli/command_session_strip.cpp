#include <fmt/format.h>

#include "app/cli/session_commands.h"
#include "app/recording/session_text.h"
#include "app/recording/strip_export.h"
#include "app/recording/what_if.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/log/session_strip.h"

namespace terratact {
namespace {

std::size_t columnsOf(const Strip& strip)
{
    std::size_t columns = 0;
    for (const StripSection& section : strip.sections()) columns += section.columns.size();
    return columns;
}

}  // namespace

Status exportStrip(const SessionStripOptions& options)
{
    const bool isPly = options.out.ends_with(".ply");
    if (!isPly && !options.out.ends_with(".csv"))
        return Error{options.out + ": the ending tells the format, expected .csv or .ply"};
    auto session = SessionReader::open(options.file);
    if (!session) return session.error();
    const auto robot = robotOf(*session);
    if (!robot) return robot.error();
    SessionStrip followed(*session, *robot);
    followed.goTo(session->end());
    const Strip& strip = followed.strip();
    const std::size_t sections = strip.sections().size();
    for (const SessionDamage& damage : session->damage())
        printText(stderr, "terratact: {}: left out: {}\n", options.file,
                  damageText(session->start(), damage));
    if (sections == 0)
        return Error{
            options.file
            + ": no strip, because it holds no estimate, or its robot reports no odometry"};
    if (options.section && static_cast<std::size_t>(*options.section) > sections)
        return Error{fmt::format("{}: has {} sections, expected --section 1 to {}", options.file,
                                 sections, sections)};
    const std::string text =
        isPly ? stripPly(strip, *robot, options.section) : stripCsv(strip, *robot, options.section);
    if (Status written = writeText(options.out, text); !written) return written;
    printText(messagesBeside(options.out), "{} m of ground, sections: {}; written to {}\n",
              fmt::format("{:.1f}", kBinWidth * static_cast<double>(columnsOf(strip))), sections,
              options.out);
    return Done{};
}

}  // namespace terratact
