#pragma once

#include <QList>
#include <QString>
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

QString markOf(Precondition::Level level);  ///< "✔", "!" or "✘"
/// One line each, with its mark: a tip of the command.
QString linesOf(const QList<Precondition>& preconditions);
/// The first that is Missing, in words; empty: none is.
QString firstMissing(const QList<Precondition>& preconditions);

}  // namespace terratact
