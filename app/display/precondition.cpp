#include "app/display/precondition.h"

#include <QStringList>
#include <algorithm>

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
        lines << markOf(p.level) + QLatin1Char(' ') + p.text;
    return lines.join(QLatin1Char('\n'));
}

Precondition::Level worstOf(const QList<Precondition>& preconditions)
{
    Precondition::Level worst = Precondition::Level::Met;
    for (const Precondition& p : preconditions) worst = std::max(worst, p.level);
    return worst;
}

QString firstMissing(const QList<Precondition>& preconditions)
{
    const auto missing =
        std::find_if(preconditions.begin(), preconditions.end(),
                     [](const Precondition& p) { return p.level == Precondition::Level::Missing; });
    return missing == preconditions.end() ? QString() : missing->text;
}

}  // namespace terratact
