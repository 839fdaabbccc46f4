#include "app/display/translated.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <optional>
#include <vector>

#include "app/display/format.h"
#include "app/display/units.h"
#include "core/base/degree.h"

namespace terratact {
namespace {

/// Returns the number of a text such as "+0.25" with `factor` applied and `fewer` decimals less; empty: it is none.
std::optional<QString> converted(const QString& text, double factor, int fewer)
{
    QString plain = text;
    plain.replace(QChar(0x2212), QLatin1Char('-'));
    bool isNumber = false;
    const double value = plain.toDouble(&isNumber);
    if (!isNumber || plain.contains(QLatin1Char('e'))) return std::nullopt;
    const qsizetype point = plain.indexOf(QLatin1Char('.'));
    const int decimals = point < 0 ? 0 : static_cast<int>(plain.size() - point - 1);
    const int wanted = std::max(0, decimals - fewer);
    return plain.startsWith(QLatin1Char('+')) ? format::signedNumber(factor * value, wanted)
                                              : format::number(factor * value, wanted);
}

/// A unit of the sentence, and the one that is shown instead.
struct Conversion {
    const char* from;
    const char* to;
    double factor;
    int fewer;  ///< decimals
};

/// Returns the conversions that units() ask for.
std::vector<Conversion> conversions()
{
    std::vector<Conversion> all;
    if (units().length == LengthUnit::Centimetre) all.push_back({" m", " cm", 100.0, 2});
    if (units().angle == AngleUnit::Radian) all.push_back({"°", " rad", kDegree, -2});
    return all;
}

/// Returns true if a unit ends here: neither "mm" nor "m/min" begins with a metre.
bool endsUnit(const QString& after)
{
    return after.isEmpty() || (!after.at(0).isLetter() && after.at(0) != QLatin1Char('/'));
}

/// Converts the numbers that the sentence itself names, such as "0.1 m".
void convertLiterals(QString& sentence)
{
    static const QRegularExpression number(QStringLiteral("(?<![%\\w.])(\\d+(?:\\.\\d+)?)( m|°)"));
    for (const Conversion& unit : conversions()) {
        qsizetype from = 0;
        for (auto match = number.match(sentence); match.hasMatch();
             match = number.match(sentence, from)) {
            from = match.capturedEnd();
            const auto value = converted(match.captured(1), unit.factor, unit.fewer);
            if (match.captured(2) != QString::fromUtf8(unit.from) || !value
                || !endsUnit(sentence.mid(from)))
                continue;
            const QString text = *value + QString::fromUtf8(unit.to);
            from = match.capturedStart() + text.size();
            sentence.replace(match.capturedStart(), match.capturedLength(), text);
        }
    }
}

/// Converts numbers of a message to units(): those before a unit in the sentence, and arguments that end in one.
void convert(QString& sentence, std::vector<std::string>& arguments)
{
    convertLiterals(sentence);
    for (std::size_t i = 0; i < arguments.size(); ++i)
        for (const Conversion& unit : conversions()) {
            const QString from = QString::fromUtf8(unit.from), to = QString::fromUtf8(unit.to);
            const QString place = QLatin1Char('%') + QString::number(i + 1) + from;
            QString argument = QString::fromStdString(arguments[i]);
            const bool ends = argument.endsWith(from);
            if (ends) argument.chop(from.size());
            const qsizetype at = sentence.indexOf(place);
            if (!ends && (at < 0 || !endsUnit(sentence.mid(at + place.size())))) continue;
            const auto number = converted(argument, unit.factor, unit.fewer);
            if (!number) continue;
            arguments[i] = (ends ? *number + to : *number).toStdString();
            if (!ends) sentence.replace(at, place.size(), place.chopped(from.size()) + to);
        }
}

/// Returns the message in the operator's language, in these units.
std::string inLanguage(const Message& message, const Units& shown)
{
    std::string source =
        message.context.empty()
            ? message.source
            : QCoreApplication::translate(message.context.c_str(), message.source.c_str())
                  .toStdString();
    if (message.arguments.empty()) return source;
    std::vector<std::string> arguments;
    arguments.reserve(message.arguments.size());
    for (const Message& argument : message.arguments)
        arguments.push_back(inLanguage(argument, shown));
    if (shown != Units{}) {
        QString sentence = QString::fromStdString(source);
        convert(sentence, arguments);
        source = sentence.toStdString();
    }
    return terratact::filled(source, [&arguments](std::size_t place) {
        return place <= arguments.size() ? arguments[place - 1] : std::string();
    });
}

}  // namespace

QString translated(const Message& message)
{
    return format::text(inLanguage(message, units()));
}

QString translatedLine(const Message& message)
{
    return translated(message).replace(QLatin1Char('\n'), QLatin1Char(' '));
}

std::string inReadersLanguage(const Message& message)
{
    return format::text(inLanguage(message, Units{})).toStdString();
}

Message verbatim(const QString& text)
{
    return Message::verbatim(text.toStdString());
}

}  // namespace terratact
