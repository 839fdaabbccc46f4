#pragma once

class QApplication;
class QWidget;

namespace terratact {

/// Lets the widgets on hidden pages of visible windows miss the next changes of the application's style sheet. They
/// learn of them from styleHiddenPages(), which idle time calls too, or when they are shown. A page is a child of a
/// QStackedWidget. Only GUI thread.
void postponeHiddenPages(QApplication& application);

/// Styles postponed widgets for about this time [ms], or all of them. Returns true if none waits any more.
bool styleHiddenPages(int most);
void styleHiddenPages();

/// Styles the postponed widgets of one page, which will be shown.
void styleHiddenPage(QWidget& page);

}  // namespace terratact
