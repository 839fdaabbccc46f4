#include "app/shell/preferences.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <QStringList>
#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "core/base/named.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

constexpr auto kThemeNameNames = namesOf<ThemeName>("day", "night-red", "high-contrast");
constexpr auto kLayoutNames = namesOf<Layout>("drive", "probe", "review");

constexpr qint64 kLargestFile = 1 << 20;  // [bytes]
constexpr std::array kThemes{ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast};
constexpr std::array kLayouts{Layout::Drive, Layout::Probe, Layout::Review};
const QString kSchemaKey = QStringLiteral("schema");

bool isPath(const QString& text)
{
    constexpr int kMaxLength = 4096;
    return text.size() <= kMaxLength && !text.contains(QChar(0));
}

/// Reads one value per key; every value is stored as text.
struct Reader {
    const QSettings& file;
    std::vector<Message>& troubles;

    /// parse: sets the value from the text; returns false if the text is invalid.
    template <class Parse>
    void value(const char* key, Parse parse)
    {
        if (!file.contains(QLatin1String(key))) return;
        const QVariant found = file.value(QLatin1String(key));
        if (found.typeId() == QMetaType::QString && parse(found.toString())) return;
        troubles.emplace_back(
            TR_NOOP("Preferences", "Preferences: “%1” is no valid %2, its default is used"),
            verbatim(found.toString().left(40).simplified()), key);
    }
    void number(const char* key, double& to, PreferenceRange range)
    {
        value(key, [&](const QString& text) {
            bool good = false;
            const double parsed = text.toDouble(&good);
            if (!good || !(parsed >= range.least && parsed <= range.most)) return false;
            to = parsed;
            return true;
        });
    }
    void number(const char* key, int& to, int least, int most)
    {
        value(key, [&](const QString& text) {
            bool good = false;
            const int parsed = text.toInt(&good);
            if (!good || parsed < least || parsed > most) return false;
            to = parsed;
            return true;
        });
    }
    template <class Value, class Choices>
    void oneOf(const char* key, Value& to, const Choices& choices)
    {
        value(key, [&](const QString& text) {
            for (const Value choice : choices) {
                if (format::text(name(choice)) != text) continue;
                to = choice;
                return true;
            }
            return false;
        });
    }
    void flag(const char* key, bool& to)
    {
        value(key, [&](const QString& text) {
            if (text != QLatin1String("true") && text != QLatin1String("false")) return false;
            to = text == QLatin1String("true");
            return true;
        });
    }
    void language(const char* key, QString& to)
    {
        value(key, [&](const QString& text) {
            const bool known = QStringList{QString(), "en", "cs", "de"}.contains(text);
            if (known) to = text;
            return known;
        });
    }
    void path(const char* key, QString& to)
    {
        value(key, [&](const QString& text) {
            if (isPath(text)) to = text;
            return isPath(text);
        });
    }
    void paths(const char* key, QStringList& to)
    {
        value(key, [&](const QString& text) {
            QStringList found = text.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
            const bool good =
                found.size() <= kMaxDbcFiles && std::all_of(found.begin(), found.end(), isPath);
            if (good) to = std::move(found);
            return good;
        });
    }
    void mapping(const char* key, PadMapping& to)
    {
        value(key, [&](const QString& text) {
            const auto parsed = PadMapping::parse(text.toStdString());
            if (parsed) to = *parsed;
            return parsed.has_value();
        });
    }
    void lines(const char* key, QStringList& to, qsizetype most)
    {
        value(key, [&](const QString& text) {
            QStringList found = text.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
            const bool good = found.size() <= most;
            if (good) to = std::move(found);
            return good;
        });
    }
    void bytes(const char* key, QByteArray& to)
    {
        value(key, [&](const QString& text) {
            constexpr int kMaxLength = 4096;
            const auto decoded = QByteArray::fromBase64Encoding(
                text.toLatin1(), QByteArray::AbortOnBase64DecodingErrors);
            if (!decoded || decoded.decoded.size() > kMaxLength) return false;
            to = decoded.decoded;
            return true;
        });
    }
};

struct Writer {
    std::function<void(const char* key, const QString& text)> value;

    void number(const char* key, double value_, PreferenceRange)
    {
        value(key, QString::number(value_, 'g', QLocale::FloatingPointShortest));
    }
    void number(const char* key, int value_, int, int) { value(key, QString::number(value_)); }
    template <class Value, class Choices>
    void oneOf(const char* key, Value value_, const Choices&)
    {
        value(key, format::text(name(value_)));
    }
    void flag(const char* key, bool value_) { value(key, value_ ? "true" : "false"); }
    void language(const char* key, const QString& value_) { value(key, value_); }
    void path(const char* key, const QString& value_) { value(key, value_); }
    void paths(const char* key, const QStringList& value_)
    {
        value(key, value_.join(QLatin1Char('\n')));
    }
    void mapping(const char* key, const PadMapping& value_)
    {
        value(key, QString::fromStdString(value_.text()));
    }
    void lines(const char* key, const QStringList& value_, qsizetype)
    {
        value(key, value_.join(QLatin1Char('\n')));
    }
    void bytes(const char* key, const QByteArray& value_)
    {
        value(key, QString::fromLatin1(value_.toBase64()));
    }
};

/// Visits every preference with its key and limits, for reading and writing.
template <class Visitor, class Values>
void visit(Visitor visitor, Values& p)
{
    visitor.oneOf("theme", p.theme, kThemes);
    visitor.number("font-scale", p.fontScale, kSmallestFont, kLargestFont);
    visitor.language("language", p.language);
    visitor.oneOf("layout", p.layout, kLayouts);
    visitor.flag("sound", p.sound);
    visitor.number("contact-sound", p.contactSound, 0, 100);
    visitor.number("obstacle-limit", p.obstacleLimit, kObstacleRange);
    visitor.oneOf("method", p.method, offeredMethods());
    visitor.oneOf("quality", p.preset, kQualityPresets);
    visitor.number("estimate-seconds", p.estimateSeconds, 0, kMaxEstimateSeconds);
    visitor.number("force-threshold", p.forceThreshold, kForceRange);
    visitor.oneOf("probe-policy", p.probes, kProbePolicies);
    visitor.number("probe-above", p.probeAbove, kProbeAboveRange);
    visitor.number("roll-limit", p.rollLimit, kRollRange);
    visitor.number("hazard-rate", p.hazardRate, kHazardRateRange);
    visitor.number("asymmetry-limit", p.asymmetryLimit, kAsymmetryRange);
    visitor.number("tilt-amber", p.tiltAmber, kTiltRange);
    visitor.number("tilt-red", p.tiltRed, kTiltRange);
    visitor.flag("record", p.record);
    visitor.number("keep-days", p.keepDays, 0, kMaxDays);
    visitor.number("keep-gigabytes", p.keepGigabytes, 0, kMaxGigabytes);
    visitor.flag("may-delete", p.mayDelete);
    visitor.path("model", p.model);
    visitor.path("robot", p.robot);
    visitor.paths("dbc", p.dbc);
    visitor.mapping("gamepad", p.pad.mapping);
    visitor.number("gamepad-dead-zone", p.pad.deadZone, kDeadZoneRange);
    visitor.number("gamepad-speed", p.pad.speedLimit, kPadSpeedRange);
    visitor.lines("plot-sets", p.plotSets, kMaxPlotSets);
    visitor.path("session-folder", p.sessionFolder);
    visitor.bytes("window", p.window);
}

/// Moves the file aside and reports it. If that fails, nothing may be saved.
void setAside(const QString& path, const Message& why, LoadedPreferences& loaded)
{
    const QString bad = path + QStringLiteral(".bad");
    QFile::remove(bad);
    if (QFile::rename(path, bad)) {
        loaded.troubles.emplace_back(
            TR_NOOP("Preferences",
                    "Preferences: %1; the file is set aside as %2, defaults are used"),
            why, verbatim(bad));
    } else {
        loaded.troubles.emplace_back(
            TR_NOOP("Preferences", "Preferences: %1; defaults are used and nothing is saved"), why);
        loaded.path.clear();
    }
}

}  // namespace

std::string_view name(ThemeName theme)
{
    return nameIn(kThemeNameNames, theme);
}

std::string_view name(Layout layout)
{
    return nameIn(kLayoutNames, layout);
}

std::vector<Method> offeredMethods()
{
    std::vector<Method> methods(kMethods.begin(), kMethods.end());
    std::erase(methods, Method::Pafac);
    return methods;
}

Settings withPreferences(Settings settings, const Preferences& preferences)
{
    settings = withPreset(settings, preferences.preset);
    settings.method = preferences.method;
    settings.forceThreshold = preferences.forceThreshold;
    settings.probeAbove = preferences.probeAbove;
    settings.rollLimit = preferences.rollLimit;
    settings.hazardRate = preferences.hazardRate;
    settings.asymmetryLimit = preferences.asymmetryLimit;
    return settings;
}

Message robotNotUsed(const Error& why)
{
    return {TR_NOOP("Preferences", "Preferences: %1; the shipped robot is used"), why.message};
}

Message modelNotUsed(const QString& path)
{
    return {TR_NOOP("Preferences", "Preferences: %1 cannot be read; the shipped model is used"),
            verbatim(path)};
}

QString preferencesPath()
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation);
    return folder.isEmpty() ? QString() : folder + QStringLiteral("/terratact/console.ini");
}

LoadedPreferences loadPreferences(const QString& path)
{
    LoadedPreferences loaded;
    loaded.path = path;
    const QFileInfo info(path);
    if (path.isEmpty() || !info.exists()) return loaded;
    if (!info.isFile()) {  // a folder, or a pipe that would block forever
        loaded.path.clear();
        loaded.troubles.emplace_back(
            TR_NOOP("Preferences",
                    "Preferences: %1 is no file; defaults are used and nothing is saved"),
            verbatim(path));
        return loaded;
    }
    if (!info.isReadable()) {
        loaded.path.clear();
        loaded.troubles.emplace_back(
            TR_NOOP("Preferences",
                    "Preferences: %1 cannot be read; defaults are used and nothing is saved"),
            verbatim(path));
        return loaded;
    }
    if (info.size() > kLargestFile) {
        setAside(path, {TR_NOOP("Preferences", "%1 is too large"), verbatim(path)}, loaded);
        return loaded;
    }
    const QSettings file(path, QSettings::IniFormat);
    bool numbered = false;
    const int schema = file.value(kSchemaKey).toString().toInt(&numbered);
    if (file.status() != QSettings::NoError || !numbered || schema < 1) {
        setAside(path, {TR_NOOP("Preferences", "%1 is not understood"), verbatim(path)}, loaded);
    } else if (schema > kPreferencesSchema) {
        loaded.path.clear();
        loaded.troubles.emplace_back(
            TR_NOOP("Preferences",
                    "Preferences: %1 was written by a newer version; defaults are used and "
                    "nothing is saved"),
            verbatim(path));
    } else {
        visit(Reader{file, loaded.troubles}, loaded.preferences);
    }
    return loaded;
}

QString changesOf(const Preferences& before, const Preferences& now)
{
    const auto listed = [](Preferences preferences) {
        QList<std::pair<QString, QString>> values;
        preferences.window.clear();
        preferences.plotSets.clear();
        preferences.sessionFolder.clear();
        visit(Writer{[&values](const char* key, const QString& text) {
                  values.emplace_back(QLatin1String(key), text);
              }},
              preferences);
        return values;
    };
    const auto old = listed(before), wanted = listed(now);
    QStringList changes;
    for (qsizetype i = 0; i < old.size(); ++i)
        if (old[i] != wanted[i])
            changes
                << QStringLiteral("%1: %2 → %3").arg(old[i].first, old[i].second, wanted[i].second);
    return changes.join(QStringLiteral("; "));
}

std::optional<Message> savePreferences(const QString& path, const Preferences& preferences)
{
    if (path.isEmpty()) return std::nullopt;
    Status allowed = makeDirectory(QFileInfo(path).path().toStdString(), Access::Owner);
    if (allowed) allowed = checkLinks(path.toStdString());
    if (!allowed)
        return Message(TR_NOOP("Preferences", "Preferences: %1; nothing is saved"),
                       allowed.error().message);
    QSettings file(path, QSettings::IniFormat);
    file.setValue(kSchemaKey, QString::number(kPreferencesSchema));
    visit(Writer{[&file](const char* key, const QString& text) {
              file.setValue(QLatin1String(key), text);
          }},
          preferences);
    file.sync();
    if (file.status() == QSettings::NoError) return std::nullopt;
    return Message(TR_NOOP("Preferences", "Preferences: %1 cannot be written"), verbatim(path));
}

}  // namespace terratact
