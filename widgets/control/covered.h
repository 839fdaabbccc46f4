#pragma once

class QWidget;

namespace terratact {

/// Returns true if a menu, or another dialog of the widget's window, lies over a part of the widget.
bool isCovered(const QWidget& widget);

}  // namespace terratact
