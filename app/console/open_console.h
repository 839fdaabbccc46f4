#pragma once

#include "app/shell/application.h"
#include "app/shell/console_options.h"
#include "core/base/result.h"

namespace terratact {

/// Opens the console on a robot and stays until it is closed, or has saved the picture that was asked for; opens it
/// anew where that is wanted.  The program's exit code.
Result<int> openConsole(Application& application, const ConsoleOptions& options);

}  // namespace terratact
