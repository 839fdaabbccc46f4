#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/cli/commands.h"
#include "app/link/can_check.h"
#include "app/runtime/print_text.h"
#include "core/store/file_read.h"
#include "core/wire/logs/log_reader.h"
#include "drivers/can_interface.h"
#include "drivers/socketcan.h"

namespace terratact {
namespace {

const char* wordOf(CanFinding::Level level)
{
    switch (level) {
    case CanFinding::Level::Fine: return "fine";
    case CanFinding::Level::Warning: return "warning";
    case CanFinding::Level::Problem: break;
    }
    return "problem";
}

void showFinding(CanFinding::Level level, const std::string& what)
{
    printText("{:<8} {}\n", wordOf(level), what);
}

/// Prints the content of a log, and the faults during its recording.
Status checkLog(const std::string& path)
{
    Result<LogReader> log = LogReader::open(path);
    if (!log) return log.error();
    std::map<std::string, std::uint64_t> frames;
    std::uint64_t untimed = 0, others = 0;
    for (;;) {
        const auto logged = log->next();
        for (const Message& remark : log->consumeRemarks())
            showFinding(CanFinding::Level::Warning, remark.english());
        if (!logged) return logged.error();
        if (!*logged) break;
        if (!(*logged)->time) ++untimed;
        const std::string& name = (*logged)->interface;
        if (frames.size() < 64 || frames.contains(name))
            ++frames[name];
        else
            ++others;
    }
    if (frames.empty()) return fileError(path, "holds no frame: is it a log of a CAN bus?");
    showFinding(CanFinding::Level::Fine, "it is a log of the format " + log->format());
    for (const auto& [name, count] : frames)
        showFinding(CanFinding::Level::Fine, fmt::format("{} frames of {}", count, name));
    if (others > 0)
        showFinding(CanFinding::Level::Fine, fmt::format("{} frames of other interfaces", others));
    showFinding(CanFinding::Level::Fine, fmt::format("it lasts {:.3f} s", log->elapsed()));
    if (untimed > 0)
        showFinding(CanFinding::Level::Warning,
                    fmt::format("{} frames have no time: record with candump -L", untimed));
    if (log->dropped() > 0)
        showFinding(CanFinding::Level::Warning,
                    fmt::format("{} frames were lost when the log was recorded", log->dropped()));
    return Done{};
}

}  // namespace

Status checkCan(const std::string& interface)
{
    std::error_code ignored;
    if (interface == "-" || std::filesystem::is_regular_file(interface, ignored))
        return checkLog(interface);
    if (Status name = checkInterfaceName(interface); !name) return name;
    const CanInterfaceFacts facts = inspectInterface(interface);
    const CanController controller =
        facts.isCan && !facts.isVirtual ? controllerFrom(linkDetails(interface)) : CanController{};
    const std::vector<CanFinding> findings = findingsOf(facts, canSocketError(), controller);
    for (const CanFinding& finding : findings) {
        printText("{:<8} {}\n", wordOf(finding.level), finding.what.english());
        if (!finding.cure.empty()) printText("{:<8} → {}\n", "", finding.cure.english());
    }
    const auto problems = std::count_if(findings.begin(), findings.end(), [](const CanFinding& f) {
        return f.level == CanFinding::Level::Problem;
    });
    if (problems == 0) return Done{};
    return Error{fmt::format("{} cannot be used: {} problem{}, see above", interface, problems,
                             problems == 1 ? "" : "s")};
}

}  // namespace terratact
