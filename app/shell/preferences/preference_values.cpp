#include "app/shell/preferences/preference_values.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"

namespace terratact {
namespace {

constexpr std::array kThemes{ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast};
constexpr std::array kLayouts{Layout::Drive, Layout::Probe, Layout::Review};
constexpr std::array kLengthUnits{LengthUnit::Metre, LengthUnit::Centimetre};
constexpr std::array kAngleUnits{AngleUnit::Degree, AngleUnit::Radian};
const QStringList kLanguageCodes{QString(), "en", "cs", "de"};

bool isPath(const QString& text)
{
    constexpr int kMaxLength = 4096;
    return text.size() <= kMaxLength && !text.contains(QChar(0));
}

QStringList linesOf(const QString& text)
{
    return text.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

Message withUnit(double value, const char* unit)
{
    QString text = QString::number(value, 'g', 4);
    if (*unit) text += QLatin1Char(' ') + QLatin1String(unit);
    return verbatim(text);
}

Message rangeText(double least, double most, const char* unit)
{
    return {TR_NOOP("Preferences", "a number from %1 to %2"), withUnit(least, unit),
            withUnit(most, unit)};
}

/// Sets the preference of one key from its text.
struct Setter {
    const QString& wanted;  ///< key
    const QString& text;
    bool& found;                       ///< the key exists
    std::optional<Message>& expected;  ///< if the text is not valid

    /// parse: sets the value from the text; returns false if the text is invalid.
    template <class Parse, class Expected>
    void value(const char* key, Parse parse, Expected what)
    {
        if (wanted != QLatin1String(key)) return;
        found = true;
        if (!parse()) expected = what();
    }
    void number(const char* key, double& to, PreferenceRange range, const char* unit)
    {
        value(
            key,
            [&] {
                bool good = false;
                const double parsed = text.toDouble(&good);
                if (!good || !(parsed >= range.least && parsed <= range.most)) return false;
                to = parsed;
                return true;
            },
            [&] { return rangeText(range.least, range.most, unit); });
    }
    void number(const char* key, int& to, int least, int most, const char* unit)
    {
        value(
            key,
            [&] {
                bool good = false;
                const int parsed = text.toInt(&good);
                if (!good || parsed < least || parsed > most) return false;
                to = parsed;
                return true;
            },
            [&] { return rangeText(least, most, unit); });
    }
    template <class Value, class Choices>
    void oneOf(const char* key, Value& to, const Choices& choices)
    {
        value(
            key,
            [&] {
                for (const Value choice : choices) {
                    if (format::text(name(choice)) != text) continue;
                    to = choice;
                    return true;
                }
                return false;
            },
            [&] {
                QStringList names;
                for (const Value choice : choices) names << format::text(name(choice));
                return Message(TR_NOOP("Preferences", "one of %1"),
                               verbatim(names.join(QStringLiteral(", "))));
            });
    }
    void flag(const char* key, bool& to)
    {
        value(
            key,
            [&] {
                if (text != QLatin1String("true") && text != QLatin1String("false")) return false;
                to = text == QLatin1String("true");
                return true;
            },
            [] { return Message(TR_NOOP("Preferences", "true or false")); });
    }
    void language(const char* key, QString& to)
    {
        value(
            key,
            [&] {
                const bool known = kLanguageCodes.contains(text);
                if (known) to = text;
                return known;
            },
            [] { return Message(TR_NOOP("Preferences", "en, cs, de or nothing")); });
    }
    void path(const char* key, QString& to)
    {
        value(
            key,
            [&] {
                if (isPath(text)) to = text;
                return isPath(text);
            },
            [] { return Message(TR_NOOP("Preferences", "the path of a file")); });
    }
    void paths(const char* key, QStringList& to)
    {
        value(
            key,
            [&] {
                QStringList found_ = linesOf(text);
                const bool good = found_.size() <= kMaxDbcFiles
                               && std::all_of(found_.begin(), found_.end(), isPath);
                if (good) to = std::move(found_);
                return good;
            },
            [] {
                return Message(TR_NOOP("Preferences", "paths of at most %1 files"), kMaxDbcFiles);
            });
    }
    void mapping(const char* key, PadMapping& to)
    {
        value(
            key,
            [&] {
                const auto parsed = PadMapping::parse(text.toStdString());
                if (parsed) to = *parsed;
                return parsed.has_value();
            },
            [] {
                return Message(
                    TR_NOOP("Preferences", "controls of a gamepad as this program writes them"));
            });
    }
    void lines(const char* key, QStringList& to, qsizetype most)
    {
        value(
            key,
            [&] {
                QStringList found_ = linesOf(text);
                const bool good = found_.size() <= most;
                if (good) to = std::move(found_);
                return good;
            },
            [&] { return Message(TR_NOOP("Preferences", "at most %1 lines"), most); });
    }
    void bytes(const char* key, QByteArray& to)
    {
        value(
            key,
            [&] {
                constexpr int kMaxLength = 4096;
                const auto decoded = QByteArray::fromBase64Encoding(
                    text.toLatin1(), QByteArray::AbortOnBase64DecodingErrors);
                if (!decoded || decoded.decoded.size() > kMaxLength) return false;
                to = decoded.decoded;
                return true;
            },
            [] { return Message(TR_NOOP("Preferences", "a window geometry in base64")); });
    }
};

/// Lists every preference as text.
struct Lister {
    std::vector<PreferenceValue>& values;

    void add(const char* key, QString text, const char* unit = "", bool isList = false)
    {
        values.push_back({key, std::move(text), unit, isList});
    }
    void number(const char* key, double value, PreferenceRange, const char* unit)
    {
        add(key, QString::number(value, 'g', QLocale::FloatingPointShortest), unit);
    }
    void number(const char* key, int value, int, int, const char* unit)
    {
        add(key, QString::number(value), unit);
    }
    template <class Value, class Choices>
    void oneOf(const char* key, Value value, const Choices&)
    {
        add(key, format::text(name(value)));
    }
    void flag(const char* key, bool value) { add(key, value ? "true" : "false"); }
    void language(const char* key, const QString& value) { add(key, value); }
    void path(const char* key, const QString& value) { add(key, value); }
    void paths(const char* key, const QStringList& value) { lines(key, value, 0); }
    void mapping(const char* key, const PadMapping& value)
    {
        add(key, QString::fromStdString(value.text()));
    }
    void lines(const char* key, const QStringList& value, qsizetype)
    {
        add(key, value.join(QLatin1Char('\n')), "", true);
    }
    void bytes(const char* key, const QByteArray& value)
    {
        add(key, QString::fromLatin1(value.toBase64()));
    }
};

/// Visits every preference with its key and limits, for reading and writing.
template <class Visitor, class Values>
void visitPreferences(Visitor visitor, Values& p)
{
    visitor.oneOf("theme", p.theme, kThemes);
    visitor.number("font-scale", p.fontScale, kSmallestFont, kLargestFont, "%");
    visitor.language("language", p.language);
    visitor.oneOf("length-unit", p.units.length, kLengthUnits);
    visitor.oneOf("angle-unit", p.units.angle, kAngleUnits);
    visitor.oneOf("layout", p.layout, kLayouts);
    visitor.flag("sound", p.sound);
    visitor.number("contact-sound", p.contactSound, 0, 100, "%");
    visitor.number("obstacle-limit", p.obstacleLimit, kObstacleRange, "m");
    visitor.oneOf("method", p.method, offeredMethods());
    visitor.oneOf("quality", p.preset, kQualityPresets);
    visitor.number("estimate-seconds", p.estimateSeconds, 0, kMaxEstimateSeconds, "s");
    visitor.number("force-threshold", p.forceThreshold, kForceRange, "N");
    visitor.oneOf("probe-policy", p.probes, kProbePolicies);
    visitor.number("probe-above", p.probeAbove, kProbeAboveRange, "m");
    visitor.number("roll-limit", p.rollLimit, kRollRange, "rad");
    visitor.number("hazard-rate", p.hazardRate, kHazardRateRange, "");
    visitor.number("asymmetry-limit", p.asymmetryLimit, kAsymmetryRange, "rad");
    visitor.number("tilt-amber", p.tiltAmber, kTiltRange, "rad");
    visitor.number("tilt-red", p.tiltRed, kTiltRange, "rad");
    visitor.flag("record", p.record);
    visitor.number("keep-days", p.keepDays, 0, kMaxDays, "days");
    visitor.number("keep-gigabytes", p.keepGigabytes, 0, kMaxGigabytes, "GB");
    visitor.flag("may-delete", p.mayDelete);
    visitor.path("model", p.model);
    visitor.path("robot", p.robot);
    visitor.paths("dbc", p.dbc);
    visitor.mapping("gamepad", p.pad.mapping);
    visitor.number("gamepad-dead-zone", p.pad.deadZone, kDeadZoneRange, "");
    visitor.number("gamepad-speed", p.pad.speedLimit, kPadSpeedRange, "m/s");
    visitor.lines("plot-sets", p.plotSets, kMaxPlotSets);
    visitor.path("session-folder", p.sessionFolder);
    visitor.bytes("window", p.window);
}

}  // namespace

std::vector<PreferenceValue> valuesOf(const Preferences& preferences)
{
    std::vector<PreferenceValue> values;
    visitPreferences(Lister{values}, preferences);
    return values;
}

std::optional<Message> setValue(Preferences& preferences, const QString& key, const QString& text)
{
    bool found = false;
    std::optional<Message> expected;
    visitPreferences(Setter{key, text, found, expected}, preferences);
    if (!found) return Message(TR_NOOP("Preferences", "a setting of this version"));
    return expected;
}

}  // namespace terratact
