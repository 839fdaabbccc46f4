#pragma once

#include <QWidget>

namespace terratact {

/// A page of the console besides the terrain page.
class Page : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    /// Shows the newest state; called for every frame of the window while the page is visible. now: steady clock [s].
    virtual void refresh(double now) = 0;
};

}  // namespace terratact
