#pragma once

class QApplication;

namespace terratact {

/// Lets hidden scroll areas, tables and lists learn of a new style when they are shown. At each
/// change of the style, Qt lays out all of them, also those of pages that nobody sees. Call once.
void restyleHiddenAreasLate(QApplication& application);

}  // namespace terratact
