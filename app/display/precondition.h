#pragma once

#include <QList>
#include <QString>
#include <array>
#include <cstdint>
#include <optional>

#include "core/base/message.h"

namespace terratact {

/// One precondition of a command and the text of its reason.
struct Precondition {
    /// Shown as ✔ (Met), ! (Overridden by the operator), ! (Doubtful: override first) and ✘ (Missing: no override).
    enum class Level : std::uint8_t { Met, Overridden, Doubtful, Missing };
    Level level = Level::Met;
    Message text;
    bool operator==(const Precondition&) const = default;
};

/// Commands whose preconditions can be looked up.
enum class Commanded : std::uint8_t { Explore, Drive, Arm, Probe, ReleaseStop };
inline constexpr std::array kCommanded{Commanded::Explore, Commanded::Drive, Commanded::Arm,
                                       Commanded::Probe, Commanded::ReleaseStop};

QString markOf(Precondition::Level level);  ///< "✔", "!" or "✘"
/// Returns one line per precondition with its mark, for the tip of the command.
QString linesOf(const QList<Precondition>& preconditions);
/// Returns the worst level, which decides; Met for an empty list.
Precondition::Level worstOf(const QList<Precondition>& preconditions);
/// Returns the text of the first Missing precondition; empty: none is Missing.
std::optional<Message> firstMissing(const QList<Precondition>& preconditions);

}  // namespace terratact
