#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace terratact {

/// Lets a window accept files that are dragged onto it. `open` is called with each path, at most eight of one drop.
void openDroppedFiles(QWidget& window, std::function<void(const QString& path)> open);

}  // namespace terratact
