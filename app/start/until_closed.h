#pragma once

#include <functional>

#include "app/shell/console_window.h"
#include "app/start/console_options.h"
#include "core/base/result.h"

namespace terratact {

/// Shows a window of a file until it is closed; dropped files open in other windows. For a picture it saves the window
/// once isReady() is true, and ends. Returns the program's exit code. Errors are those of saveWindow().
Result<int> untilClosed(ConsoleWindow& window, const ConsoleOptions& options,
                        const std::function<bool()>& isReady);

}  // namespace terratact
