#include "app/cli/session/session_commands.h"
#include "app/recording/session_merge.h"
#include "app/runtime/print_text.h"

namespace terratact {

Status mergeSessions(const SessionMergeOptions& options)
{
    const auto merged = mergeSessionFiles(options.files, options.out);
    if (!merged) return merged.error();
    printText("{} sessions, {} frames merged into {}; last link {}\n", merged->sessions,
              merged->frames, options.out, merged->chain);
    return Done{};
}

}  // namespace terratact
