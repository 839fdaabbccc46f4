#include <fmt/format.h>

#include <string>

#include "app/cli/session/session_commands.h"
#include "app/recording/session_rescue.h"
#include "app/recording/session_text.h"
#include "app/runtime/print_text.h"
#include "core/log/session_reader.h"

namespace terratact {
namespace {

void printLoss(const SavedSession& saved)
{
    if (!saved.isProven) printText("  but        the frames alone{}\n", kUnproven);
    if (!saved.startIsWhole)
        printText(
            "  lost       what the session said of its start: times count from 1970, the robot and "
            "the source are not known\n");
    for (const LostSpan& span : saved.spans) {
        const std::string what =
            span.batches == 1 ? "1 batch" : fmt::format("{} batches", span.batches);
        if (span.first == span.last)
            printText("  lost       {} at {}\n", what, momentText(span.first));
        else
            printText("  lost       {} between {} and {}\n", what, momentText(span.first),
                      momentText(span.last));
    }
    for (const std::string& line : saved.rest) printText("  lost       {}\n", line);
    if (saved.leftOut > 0)
        printText("  left out   {} rows that refer to a lost one\n", saved.leftOut);
}

/// Reads the new session again and prints its content.
Status printSaved(const std::string& path, const std::string& why, const SavedSession& saved)
{
    auto session = SessionReader::open(saved.out);
    if (!session) return session.error();
    const SessionVerification found = session->verify();
    printText("{}: {}\n", path, why);
    printText("  saved      {}: up to {}, {} frames, {} scenes, {} estimates, {} events\n",
              saved.out, momentText(session->end()), found.frames, session->scenes().size(),
              session->estimates().size(), found.events);
    printLoss(saved);
    if (saved.isCut)
        printText("  lost       what was recorded after {}: the file ends there\n",
                  momentText(session->end()));
    printText("  last link  {}\n", found.chain);
    return Done{};
}

Status recoverOne(const std::string& path, const std::string& out)
{
    const auto rescue = rescueSession(path, out);
    if (!rescue) return rescue.error();
    if (!rescue->why.empty()) return printSaved(path, rescue->why, rescue->saved);
    printText("{}: {}\n", path, rescue->recovered ? "recovered and closed" : "was closed already");
    return Done{};
}

}  // namespace

Status recoverSessions(const RecoverOptions& options)
{
    if (!options.out.empty() && options.files.size() != 1)
        return Error{"--out is what one session becomes"};
    for (const std::string& file : options.files)
        if (Status done = recoverOne(file, options.out); !done) return done;
    return Done{};
}

}  // namespace terratact
