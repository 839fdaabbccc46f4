#pragma once

#include <QString>
#include <string>
#include <vector>

#include "app/link/robot_file.h"
#include "app/shell/console_options.h"
#include "app/shell/preferences.h"

namespace terratact {

// What a window is opened with: what the command line says, else what is preferred, else what is shipped.

/// The user's preferences as they were saved.  A picture and a safe start have none.
LoadedPreferences preferencesFor(const ConsoleOptions& options);

/// The preferences with what the command line says.
Preferences inForce(Preferences preferences, const ConsoleOptions& options);

/// The preferred file, or where that cannot be used the shipped one, and a sentence more among the troubles.  Errors:
/// the shipped one cannot be used.
Result<RobotFile> usableRobot(const QString& preferred, std::vector<LateSentence>& troubles);
std::string usableModel(const QString& preferred, std::vector<LateSentence>& troubles);

/// The file that the command line names, else the usable one.
Result<RobotFile> robotFor(const ConsoleOptions& options, LoadedPreferences& loaded);
std::string modelFor(const ConsoleOptions& options, LoadedPreferences& loaded);

}  // namespace terratact
