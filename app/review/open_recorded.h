#pragma once

#include "app/shell/application.h"
#include "app/shell/console_options.h"
#include "core/base/result.h"

namespace terratact {

// Windows on the file that the command line names.  Each stays until it is closed, or saves a picture of itself once
// it has shown what there is.  The program's exit code.

Result<int> openReview(Application& application, const ConsoleOptions& options);  ///< a session
Result<int> openScenes(Application& application, const ConsoleOptions& options);

}  // namespace terratact
