#pragma once

class QApplication;

namespace terratact {

/// Draws a focus frame in the theme's colour around the control that has the focus. It covers controls whose own style
/// shows the focus poorly: lists, tables, pictures, spin boxes and combo boxes. Call once.
void markFocus(QApplication& application);

}  // namespace terratact
