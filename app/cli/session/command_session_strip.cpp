#include <fmt/format.h>

#include <filesystem>

#include "app/cli/session/open_session.h"
#include "app/cli/session/session_commands.h"
#include "app/figures/report/strip_file.h"
#include "app/recording/export/strip_export.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"

namespace terratact {

Status exportStrip(const SessionStripOptions& options)
{
    auto session = openSession(options.file);
    if (!session) return session.error();
    const auto robot = robotOf(*session);
    if (!robot) return robot.error();
    const auto strip = stripOf(*session, *robot);
    const std::size_t sections = strip->sections().size();
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
    const std::string title =
        stripTitle(std::filesystem::path(options.file).filename().string()).english();
    if (Status written = writeStrip(options.out, strip, *robot, title, options.section); !written)
        return written;
    printText(messagesBeside(options.out), "{} m of ground, sections: {}; written to {}\n",
              fmt::format("{:.1f}", groundOf(*strip)), sections, options.out);
    if (const std::string held = ledgerText(strip->ledger()); !held.empty())
        printText(messagesBeside(options.out), "{}\n", held);
    return Done{};
}

}  // namespace terratact
