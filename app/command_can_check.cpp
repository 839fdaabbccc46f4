#include <fmt/format.h>

#include <algorithm>

#include "app/can_check.h"
#include "app/can_commands.h"
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

}  // namespace

Status checkCan(const std::string& interface)
{
    if (Status name = checkInterfaceName(interface); !name) return name;
    const CanInterfaceFacts facts = lookAtInterface(interface);
    const CanController controller =
        facts.isCan && !facts.isVirtual ? controllerFrom(linkDetails(interface)) : CanController{};
    const std::vector<CanFinding> findings = findingsOf(facts, canSocketError(), controller);
    for (const CanFinding& finding : findings) {
        fmt::print("{:<8} {}\n", wordOf(finding.level), finding.what);
        if (!finding.cure.empty()) fmt::print("{:<8} → {}\n", "", finding.cure);
    }
    const auto problems = std::count_if(findings.begin(), findings.end(), [](const CanFinding& f) {
        return f.level == CanFinding::Level::Problem;
    });
    if (problems == 0) return Done{};
    return Error{fmt::format("{} cannot be used: {} problem{}, see above", interface, problems,
                             problems == 1 ? "" : "s")};
}

}  // namespace terratact
