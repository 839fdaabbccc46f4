#include <fmt/core.h>

#include <filesystem>

#include "app/cli/session/open_session.h"
#include "app/cli/session/session_commands.h"
#include "app/figures/report/mission_report.h"
#include "app/figures/report/session_report.h"
#include "app/runtime/print_text.h"

namespace terratact {

namespace {

Status reportMission(SessionReader& session, const SessionReportOptions& options,
                     const std::shared_ptr<const DbcBook>& book)
{
    const auto report = missionReportOf(session, {}, book);
    if (!report) return report.error();
    const bool isReplaced = std::filesystem::exists(options.out);
    if (Status written = writeDocument(options.out, *report); !written) return written;
    printText("{} written to {}{}\n", report->title, options.out,
              isReplaced ? ", in place of the file there" : "");
    return Done{};
}

}  // namespace

Status reportSession(const SessionReportOptions& options)
{
    auto session = openSession(options.file);
    if (!session) return session.error();
    const auto book = readDbcBook(CanProtocol::Terratact, options.dbc);
    if (!book) return book.error();
    for (const Message& remark : remarksOf(*book))
        printText(stderr, "terratact: {}\n", remark.english());
    if (options.mission) return reportMission(*session, options, *book);
    const auto report = reportOf(*session, options.scene, {}, *book);
    if (!report) return report.error();
    if (Status written = writeReport(options.out, *report); !written) return written;
    printText("{} written to {}\n", report->title, options.out);
    return Done{};
}

}  // namespace terratact
