#include "core/log/rows/session_rows.h"

#include <array>

#include "core/base/named.h"

namespace terratact {
namespace {

constexpr auto kRoles = namesOf<EstimateRole>("first", "again", "second");
constexpr auto kKinds =
    namesOf<EventKind>("word", "decision", "phase", "arming", "link", "forgotten", "unheard",
                       "override", "alarm", "panel", "marker", "gap", "session");

}  // namespace

std::string_view name(EstimateRole role)
{
    return nameIn(kRoles, role);
}
std::optional<EstimateRole> estimateRoleFromName(std::string_view text)
{
    return valueIn<EstimateRole>(kRoles, text);
}
std::string_view name(EventKind kind)
{
    return nameIn(kKinds, kind);
}
std::optional<EventKind> eventKindFromName(std::string_view text)
{
    return valueIn<EventKind>(kKinds, text);
}

}  // namespace terratact
