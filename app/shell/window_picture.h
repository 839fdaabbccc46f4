#pragma once

#include <string>

#include "core/base/result.h"

class QWidget;

namespace terratact {

/// Saves what a window shows as PNG, whole or not at all (core/store/file_write.h). Errors name the file.
Status saveWindow(QWidget& window, const std::string& path);

}  // namespace terratact
