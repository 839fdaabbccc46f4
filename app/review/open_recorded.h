#pragma once

#include "app/start/application.h"
#include "app/start/console_options.h"
#include "core/base/result.h"

namespace terratact {

// Open windows on the file that the command line names. Each runs until its window is closed, or until it has saved a
// picture of itself. Each returns the program's exit code.

Result<int> openReview(Application& application,
                       const ConsoleOptions& options);  ///< opens a session
Result<int> openScenes(Application& application, const ConsoleOptions& options);

}  // namespace terratact
