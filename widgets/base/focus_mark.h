#pragma once

class QApplication;

namespace terratact {

/// From now on a frame in the theme's colour stands around the control that has the focus, where its own look does not
/// show that plainly: lists, tables, pictures, boxes of numbers and choices.  Once is enough.
void markFocus(QApplication& application);

}  // namespace terratact
