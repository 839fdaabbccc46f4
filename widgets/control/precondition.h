#pragma once

#include <QList>
#include <QString>
#include <array>
#include <cstdint>

namespace terratact {

/// One condition of a command, with its reason in words.
struct Precondition {
    /// ✔, ! overridden by the operator, ! to be overridden first, ✘ cannot be overridden
    enum class Level : std::uint8_t { Met, Overridden, Doubtful, Missing };
    Level level = Level::Met;
    QString text;
    bool operator==(const Precondition&) const = default;
};

/// The commands whose preconditions can be looked up.
enum class Commanded : std::uint8_t { Explore, Drive, Arm, Probe, ReleaseStop };
inline constexpr std::array kCommanded{Commanded::Explore, Commanded::Drive, Commanded::Arm,
                                       Commanded::Probe, Commanded::ReleaseStop};

QString markOf(Precondition::Level level);  ///< "✔", "!" or "✘"
/// One line each, with its mark: a tip of the command.
QString linesOf(const QList<Precondition>& preconditions);
/// The level that decides: the worst of all; Met where there are none.
Precondition::Level worstOf(const QList<Precondition>& preconditions);
/// The first that is Missing, in words; empty: none is.
QString firstMissing(const QList<Precondition>& preconditions);

}  // namespace terratact
