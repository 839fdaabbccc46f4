#pragma once

#include "app/start/application.h"
#include "app/start/console_options.h"
#include "core/base/result.h"

namespace terratact {

/// Opens the console on a robot until it is closed or has saved the requested picture. It rebuilds the window on
/// request. Returns the program's exit code.
Result<int> openConsole(Application& application, const ConsoleOptions& options);

}  // namespace terratact
