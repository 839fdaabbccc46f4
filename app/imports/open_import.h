#pragma once

#include "app/start/application.h"
#include "app/start/console_options.h"
#include "core/base/result.h"

namespace terratact {

/// Opens a window that imports the recording that the command line names, until it is closed. Returns the program's
/// exit code. A made session opens in another window.
Result<int> openImport(Application& application, const ConsoleOptions& options);

}  // namespace terratact
