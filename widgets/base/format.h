#pragma once

#include <QString>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/base/text.h"
#include "core/terrain/bins.h"

/// Numbers as an operator reads them.  A value that is not finite reads "--".
namespace terratact::format {

inline const QString kNothing = QStringLiteral("--");

/// A text in UTF-8 that may come from a file: control characters and marks of direction as '?', but for line ends.
inline QString text(std::string_view utf8)
{
    return QString::fromStdString(printableLines(utf8));
}

/// Likewise, on one line: a line end is '?', too.
inline QString line(std::string_view utf8)
{
    return QString::fromStdString(printable(utf8));
}

/// A name that may come from a file: one line of at most 100 characters, "…" for what is beyond.
inline QString shownName(std::string_view utf8)
{
    constexpr qsizetype kMax = 100;
    QString name = line(utf8);
    if (name.size() <= kMax) return name;
    name.truncate(kMax - 1);
    if (name.back().isHighSurrogate()) name.chop(1);
    return name + QChar(0x2026);
}

/// The name of a file without its folders, as shownName() has it.
inline QString fileName(const QString& path)
{
    return shownName(path.mid(path.lastIndexOf(QLatin1Char('/')) + 1).toStdString());
}

/// A sentence of the core, in the operator's language where it is among those of core_sentences.cpp; else what of it
/// is, of the parts that ": " joins.  Its numbers are carried over.  A part of one word is a name, and stays.
QString sentence(std::string_view english);

/// A word of a session's event (EventRow), in the operator's language where it is among those that are recorded.
QString eventWord(std::string_view english);

/// A source's name, of which only what is no name of a file, a bus or an interface is in the operator's language.
QString sourceName(std::string_view english);

inline QString number(double value, int decimals)
{
    if (!std::isfinite(value)) return kNothing;
    const double shown = QString::number(value, 'f', decimals).toDouble();
    return QString::number(shown + 0.0, 'f', decimals)  // no minus before a zero
        .replace(QLatin1Char('-'), QChar(0x2212));
}

/// As the core says it: "0.01", or "< 0.01" of what would round to 0.
inline QString randomError(double sd, int decimals)
{
    return std::isfinite(sd) ? text(randomErrorText(sd, decimals)) : kNothing;
}

/// As the core says it: "1.061", or "> 100".
inline QString rhat(double value)
{
    return std::isfinite(value) ? text(rhatText(value)) : kNothing;
}

/// "83" of 0.83.
inline QString percent(double share)
{
    return number(100.0 * share, 0);
}

/// With its sign, also a plus.
inline QString signedNumber(double value, int decimals)
{
    const QString text = number(value, decimals);
    return std::isfinite(value) && !text.startsWith(QChar(0x2212)) ? QLatin1Char('+') + text : text;
}

inline QString degrees(double radians, int decimals = 1)
{
    return signedNumber(radians * 180.0 / std::numbers::pi, decimals) + QStringLiteral("°");
}

/// "bin 0.6 m"'s number.
inline QString binName(int bin)
{
    return number(binCentre(bin), 1) + QStringLiteral(" m");
}

/// "0:24"; never negative.
inline QString countdown(double seconds)
{
    if (!std::isfinite(seconds)) return kNothing;
    const int whole = static_cast<int>(std::ceil(std::clamp(seconds, 0.0, 35999.0)));
    return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

/// An age: "41 ms", "2.4 s".
inline QString age(double seconds)
{
    if (!std::isfinite(seconds)) return kNothing;
    return seconds < 1.0 ? QStringLiteral("%1 ms").arg(std::lround(seconds * 1000.0))
                         : number(seconds, 1) + QStringLiteral(" s");
}

}  // namespace terratact::format
