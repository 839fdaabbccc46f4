#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <string>
#include <vector>

#include "app/shell/preferences/preferences.h"
#include "core/base/result.h"

namespace terratact {

inline constexpr int kSettingsVersion = 1;  ///< of the files that settingsText() writes

/// What a file of settings is for.
enum class SettingsScope : std::uint8_t {
    Anywhere,     ///< an export: without paths of this computer
    ThisComputer  ///< a profile: with the files of model, robot and DBC
};

/// Settings of a file: one `key = value` a line, SI units named behind each number. A key that a file leaves out keeps
/// its present value.
struct SettingsFile {
    struct Entry {
        QString key, text;
    };
    std::vector<Entry> entries;
};

/// Returns the content of a file of settings. The window's place is left out, and what the scope excludes.
std::string settingsText(const Preferences& preferences, SettingsScope scope);

/// Reads the content of a file. Errors name file, line and what was expected. Causes: it is no file of
/// settings, has a newer version, or has an unknown or doubled key. Others: a key has no value or
/// another unit, or names a file that this computer lacks.
Result<SettingsFile> readSettings(const std::string& content, const std::string& path);
/// Reads a file of at most 1 MiB.
Result<SettingsFile> readSettingsFile(const std::string& path);

/// Writes a new file. Refuses to replace one unless `replaces`.
Status writeSettings(const std::string& path, const Preferences& preferences, SettingsScope scope,
                     bool replaces = false);

/// Returns the preferences with the file's values.
Preferences withSettings(Preferences preferences, const SettingsFile& file);

// Named profiles: files of settings in one folder.

/// Returns the folder of the profiles beside the preferences; empty without a place to save.
QString profileFolder();
/// Returns the names of the profiles in a folder, sorted.
QStringList profilesIn(const QString& folder);
/// Returns the file of a profile; any text may be a name, such as "robot A/night".
QString profilePath(const QString& folder, const QString& name);
/// Returns why a text is no name of a profile; empty: it is one.
std::optional<Message> whyNoProfileName(const QString& name);

}  // namespace terratact
