#pragma once

#include "app/start/application.h"
#include "app/start/console_options.h"
#include "core/base/result.h"

namespace terratact {

/// Opens a window with the truth file that the command line names, until it is closed, or saves its picture. Returns
/// the program's exit code.
Result<int> openTruth(Application& application, const ConsoleOptions& options);

}  // namespace terratact
