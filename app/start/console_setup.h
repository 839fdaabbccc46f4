#pragma once

#include <QString>
#include <string>
#include <vector>

#include "app/link/robot_file.h"
#include "app/shell/preferences/preferences.h"
#include "app/start/console_options.h"
#include "core/base/message.h"

namespace terratact {

// Settings of a window: the command line's, else the preferred, else the shipped ones.

/// Returns the saved preferences; defaults for a picture and for safe mode, which save none. Without a home folder,
/// `troubles` says that they cannot be saved.
LoadedPreferences preferencesFor(const ConsoleOptions& options);

/// Returns the preferences overridden by the command line.
Preferences inForce(Preferences preferences, const ConsoleOptions& options);

/// Return the preferred file, or the shipped one and an entry in `troubles` if the preferred cannot be used. The Error
/// is that of the shipped file.
Result<RobotFile> usableRobot(const QString& preferred, std::vector<Message>& troubles);
std::string usableModel(const QString& preferred, std::vector<Message>& troubles);

/// Return the file of the command line, else the usable one.
Result<RobotFile> robotFor(const ConsoleOptions& options, LoadedPreferences& loaded);
std::string modelFor(const ConsoleOptions& options, LoadedPreferences& loaded);

}  // namespace terratact
