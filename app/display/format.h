#pragma once

#include <QString>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "app/display/units.h"
#include "core/base/text.h"
#include "core/terrain/bins.h"

/// Formats numbers for the operator. A value that is not finite reads "--".
namespace terratact::format {

inline const QString kNothing = QStringLiteral("--");

/// Returns UTF-8 text that may come from a file; control and bidirectional characters become '?', line ends stay.
inline QString text(std::string_view utf8)
{
    return QString::fromStdString(printableLines(utf8));
}

/// Returns text() on one line: line ends become '?', too.
inline QString line(std::string_view utf8)
{
    return QString::fromStdString(printable(utf8));
}

/// Returns a name that may come from a file: one line of at most 100 characters, the rest elided as "…".
inline QString shownName(std::string_view utf8)
{
    constexpr qsizetype kMax = 100;
    QString name = line(utf8);
    if (name.size() <= kMax) return name;
    name.truncate(kMax - 1);
    if (name.back().isHighSurrogate()) name.chop(1);
    return name + QChar(0x2026);
}

/// Returns the name of a file without its folders, cleaned by shownName().
inline QString fileName(const QString& path)
{
    return shownName(path.mid(path.lastIndexOf(QLatin1Char('/')) + 1).toStdString());
}

/// Returns a name that a session event (EventRow) holds in the operator's language. Other texts stay.
QString eventWord(std::string_view english);

/// Returns a source's name. Names of files, buses and interfaces stay; everything else is in the operator's language.
QString sourceName(std::string_view english);

inline QString number(double value, int decimals)
{
    if (!std::isfinite(value)) return kNothing;
    const double shown = QString::number(value, 'f', decimals).toDouble();
    return QString::number(shown + 0.0, 'f', decimals)  // adding 0.0 turns −0 into 0
        .replace(QLatin1Char('-'), QChar(0x2212));
}

/// Formats a value of any size with this many digits: "−0.0123", "1.5e+07".
inline QString significant(double value, int digits)
{
    if (!std::isfinite(value)) return kNothing;
    return QString::number(value + 0.0, 'g', digits).replace(QLatin1Char('-'), QChar(0x2212));
}

/// Formats a Monte-Carlo error the way the core does: "0.01", or "< 0.01" if it would round to 0.
inline QString randomError(double sd, int decimals)
{
    return std::isfinite(sd) ? text(randomErrorText(sd, decimals)) : kNothing;
}

/// Formats R-hat the way the core does: "1.061", or "> 100".
inline QString rhat(double value)
{
    return std::isfinite(value) ? text(rhatText(value)) : kNothing;
}

/// Returns true if a probability would read 0.00 or 1.00, which it never is.
bool isExtremeProbability(double p);

/// Formats a probability: "0.97", "more than 0.99", "less than 0.01".
QString probability(double p);

/// Formats a probability with its Monte-Carlo error, which an extreme one does not show: "0.97 ± 0.01".
QString probability(double p, double monteCarloSd);

/// Formats a share as a percentage: 0.83 gives "83".
inline QString percent(double share)
{
    return number(100.0 * share, 0);
}

/// Formats a number with its sign; a plus is shown, too.
inline QString signedNumber(double value, int decimals)
{
    const QString text = number(value, decimals);
    return std::isfinite(value) && !text.startsWith(QChar(0x2212)) ? QLatin1Char('+') + text : text;
}

/// Formats an angle in degrees whatever units() are: for a Message, which translated() converts.
inline QString degrees(double radians, int decimals = 1)
{
    return signedNumber(radians * 180.0 / std::numbers::pi, decimals) + QStringLiteral("°");
}

/// Formats a length in units(): "0.10 m" or "10 cm". decimals: those of metres.
QString length(double metres, int decimals);
QString signedLength(double metres, int decimals);  ///< a plus is shown, too

/// Return the number of length() and its unit, for a range or a table.
QString lengthNumber(double metres, int decimals);
QString signedLengthNumber(double metres, int decimals);
QString lengthUnit();

/// Formats an angle in units(), without a plus: "20.0°" or "0.349 rad". decimals: those of degrees.
QString plainAngle(double radians, int decimals = 1);
QString angle(double radians, int decimals = 1);  ///< with its sign, also a plus

/// Returns the place in a bin's name: "0.6 m" in "bin 0.6 m".
inline QString binName(int bin)
{
    return length(binCentre(bin), 1);
}

/// Formats a countdown as "0:24"; negative values count as 0.
inline QString countdown(double seconds)
{
    if (!std::isfinite(seconds)) return kNothing;
    const int whole = static_cast<int>(std::ceil(std::clamp(seconds, 0.0, 35999.0)));
    return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

/// Formats an age: "41 ms", "2.4 s".
inline QString age(double seconds)
{
    if (!std::isfinite(seconds)) return kNothing;
    return seconds < 1.0 ? QStringLiteral("%1 ms").arg(std::lround(seconds * 1000.0))
                         : number(seconds, 1) + QStringLiteral(" s");
}

}  // namespace terratact::format
