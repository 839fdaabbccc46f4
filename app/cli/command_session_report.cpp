#include <fmt/core.h>

#include "app/cli/session_commands.h"
#include "app/figures/session_report.h"
#include "app/runtime/print_text.h"

namespace terratact {

Status reportSession(const SessionReportOptions& options)
{
    auto session = SessionReader::open(options.file);
    if (!session) return session.error();
    const auto book = readDbcBook(CanProtocol::Terratact, options.dbc);
    if (!book) return book.error();
    for (const Message& remark : remarksOf(*book))
        printText(stderr, "terratact: {}\n", remark.english());
    const auto report = reportOf(*session, options.scene, {}, *book);
    if (!report) return report.error();
    if (Status written = writeReport(options.out, *report); !written) return written;
    printText("{} written to {}\n", report->title, options.out);
    return Done{};
}

}  // namespace terratact
