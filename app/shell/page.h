#pragma once

#include <QWidget>

namespace terratact {

/// A page of the console beside the terrain's.
class Page : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    /// Shows the newest state; called with every picture of the window while the page is visible.  now: [s] on the steady clock.
    virtual void refresh(double now) = 0;
};

}  // namespace terratact
