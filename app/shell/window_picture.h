#pragma once

#include <string>

#include "core/base/result.h"

class QPixmap;
class QWidget;

namespace terratact {

/// Returns a picture of a window, or of a widget in it. Ends the fitting of the window's font first, because a picture
/// taken meanwhile is blank.
QPixmap pictureOf(QWidget& widget);

/// Saves what a window shows as PNG, whole or not at all (core/store/file_write.h). Errors name the file.
Status saveWindow(QWidget& window, const std::string& path);

}  // namespace terratact
