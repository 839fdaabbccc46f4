#include "core/log/session_rows.h"

#include <array>
#include <stdexcept>

namespace terratact {
namespace {

constexpr std::array<std::string_view, 3> kRoles{"first", "again", "second"};
constexpr std::array<std::string_view, kEventKinds> kKinds{
    "word",     "decision", "phase", "arming", "link", "forgotten", "unheard",
    "override", "alarm",    "panel", "marker", "gap",  "session"};

template <class Enum, std::size_t n>
std::string_view nameOf(const std::array<std::string_view, n>& names, Enum value)
{
    const auto i = static_cast<std::size_t>(value);
    if (i >= n) throw std::invalid_argument("name: no such value");
    return names[i];
}

template <class Enum, std::size_t n>
std::optional<Enum> fromName(const std::array<std::string_view, n>& names, std::string_view text)
{
    for (std::size_t i = 0; i < n; ++i)
        if (names[i] == text) return static_cast<Enum>(i);
    return std::nullopt;
}

}  // namespace

std::string_view name(EstimateRole role)
{
    return nameOf(kRoles, role);
}
std::optional<EstimateRole> estimateRoleFromName(std::string_view text)
{
    return fromName<EstimateRole>(kRoles, text);
}
std::string_view name(EventKind kind)
{
    return nameOf(kKinds, kind);
}
std::optional<EventKind> eventKindFromName(std::string_view text)
{
    return fromName<EventKind>(kKinds, text);
}

}  // namespace terratact
