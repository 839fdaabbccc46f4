#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "app/cli/session/session_commands.h"
#include "app/recording/session_folder.h"
#include "app/recording/session_listing.h"
#include "app/recording/session_text.h"
#include "app/runtime/print_text.h"

namespace terratact {
namespace {

std::string nameOfFile(const std::string& path)
{
    return std::filesystem::path(path).filename().string();
}

void printListed(const ListedSession& listed)
{
    if (!listed.summary) {
        printText("{}: {}\n", nameOfFile(listed.path), listed.trouble.english());
        return;
    }
    const SessionSummary& s = *listed.summary;
    printText(
        "{:<27}  {:>9.1f}  {:<6}  {:>8.1f}  {:>5}  {:>7}  {:>11}  {:>6}  {:>6}  {:>5}  {}  {}{}\n",
        localText(listed.wallTime()), listed.seconds(), name(s.closing),
        1e-6 * static_cast<double>(listed.bytes), s.verdicts.clear, s.verdicts.blocked,
        s.verdicts.cannotTell, s.probes, s.alarms, listed.notes(), s.robot.empty() ? "?" : s.robot,
        nameOfFile(listed.path), s.damage ? ": " + s.damage->english() : std::string());
}

}  // namespace

Status listSessions(const std::string& folder)
{
    const std::string from = folder.empty() ? sessionFolder() : folder;
    const auto files = sessionFilesIn(from);
    if (!files) return files.error();
    printText("{:<27}  {:>9}  {:<6}  {:>8}  {:>5}  {:>7}  {:>11}  {:>6}  {:>6}  {:>5}  {}\n",
              "begins", "lasts [s]", "state", "[MB]", "CLEAR", "BLOCKED", "CANNOT TELL", "probes",
              "alarms", "notes", "robot, file");
    for (const std::string& path : files->paths) printListed(listSession(path));
    if (files->leftOut > 0)
        printText(stderr, "terratact: {}: {} older recordings are left out\n", from,
                  files->leftOut);
    return Done{};
}

}  // namespace terratact
