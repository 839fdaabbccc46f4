#include "app/display/precondition.h"

#include <QStringList>
#include <algorithm>

#include "app/display/translated.h"

namespace terratact {

QString markOf(Precondition::Level level)
{
    static const QString kMarks[]{QStringLiteral("✔"), QStringLiteral("!"), QStringLiteral("!"),
                                  QStringLiteral("✘")};
    return kMarks[static_cast<std::size_t>(level)];
}

QString linesOf(const QList<Precondition>& preconditions)
{
    QStringList lines;
    for (const Precondition& p : preconditions)
        lines << markOf(p.level) + QLatin1Char(' ') + translated(p.text);
    return lines.join(QLatin1Char('\n'));
}

Precondition::Level worstOf(const QList<Precondition>& preconditions)
{
    Precondition::Level worst = Precondition::Level::Met;
    for (const Precondition& p : preconditions) worst = std::max(worst, p.level);
    return worst;
}

std::optional<Message> firstMissing(const QList<Precondition>& preconditions)
{
    const auto missing =
        std::find_if(preconditions.begin(), preconditions.end(),
                     [](const Precondition& p) { return p.level == Precondition::Level::Missing; });
    if (missing == preconditions.end()) return std::nullopt;
    return missing->text;
}

}  // namespace terratact
