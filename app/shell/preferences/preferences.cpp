#include "app/shell/preferences/preferences.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStringList>
#include <algorithm>
#include <string>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/runtime/user_folder.h"
#include "app/shell/preferences/preference_values.h"
#include "core/base/named.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

constexpr auto kThemeNameNames = namesOf<ThemeName>("day", "night-red", "high-contrast");
constexpr auto kLayoutNames = namesOf<Layout>("drive", "probe", "review");

constexpr qint64 kLargestFile = 1 << 20;  // [bytes]
constexpr int kTrailSchema = 2;           // the first whose default is Trail
const QString kSchemaKey = QStringLiteral("schema");

void readValues(const QSettings& file, LoadedPreferences& loaded)
{
    for (const PreferenceValue& value : valuesOf(Preferences{})) {
        const QString key = QLatin1String(value.key);
        if (!file.contains(key)) continue;
        const QVariant found = file.value(key);
        if (found.typeId() == QMetaType::QString
            && !setValue(loaded.preferences, key, found.toString()))
            continue;
        loaded.troubles.emplace_back(
            TR_NOOP("Preferences", "Preferences: “%1” is no valid %2, its default is used"),
            verbatim(found.toString().left(40).simplified()), value.key);
    }
}

/// Replaces Local, the default of older files, which hold every value: chosen or not. Where the way is not known,
/// Trail estimates as Local.
void chooseTrail(LoadedPreferences& loaded)
{
    if (loaded.preferences.method != Method::Local) return;
    loaded.preferences.method = Preferences{}.method;
    loaded.troubles.emplace_back(
        TR_NOOP("Preferences", "Preferences: method is now %1, the default; before, it was %2"),
        name(loaded.preferences.method), name(Method::Local));
}

/// Renames the file to *.bad and reports it. If that fails, nothing may be saved.
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
    const std::string folder = userFolder("XDG_CONFIG_HOME", ".config");
    return folder.empty() ? QString() : QString::fromStdString(folder + "/terratact/console.ini");
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
        readValues(file, loaded);
        if (schema < kTrailSchema) chooseTrail(loaded);
    }
    return loaded;
}

QString changesOf(const Preferences& before, const Preferences& now)
{
    const auto listed = [](Preferences preferences) {
        preferences.window.clear();
        preferences.plotSets.clear();
        preferences.sessionFolder.clear();
        return valuesOf(preferences);
    };
    const auto old = listed(before), wanted = listed(now);
    QStringList changes;
    for (std::size_t i = 0; i < old.size(); ++i)
        if (old[i].text != wanted[i].text)
            changes << QStringLiteral("%1: %2 → %3")
                           .arg(QLatin1String(old[i].key), old[i].text, wanted[i].text);
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
    for (const PreferenceValue& value : valuesOf(preferences))
        file.setValue(QLatin1String(value.key), value.text);
    file.sync();
    if (file.status() == QSettings::NoError) return std::nullopt;
    return Message(TR_NOOP("Preferences", "Preferences: %1 cannot be written"), verbatim(path));
}

}  // namespace terratact
