#include <QBoxLayout>
#include <QScrollArea>
#include <QStackedWidget>
#include <algorithm>

#include "app/shell/console_window.h"
#include "widgets/base/palette.h"

// The dock below the pages. It takes only height that nothing else needs.

namespace terratact {
namespace {

constexpr int kDockLeast = 150, kDockMost = 280;  // [px] at 100 %

}  // namespace

void ConsoleWindow::setDock(QWidget* docked)
{
    if (!dock_) {
        if (!docked) return;
        dock_ = new QWidget(this);
        dock_->setObjectName(QStringLiteral("dock"));
        auto* column = new QVBoxLayout(dock_);
        column->setContentsMargins(0, 0, 0, 0);
        dock_->hide();
        right_->insertWidget(1, dock_);
    }
    docked_ = docked;
    if (docked) {
        dock_->layout()->addWidget(docked);
        docked->show();
    }
    placeDock();
}

int ConsoleWindow::pagesHeight() const
{
    return height() - (dock_ && !dock_->isHidden() ? dock_->height() : 0);
}

void ConsoleWindow::placeDock()
{
    if (!dock_) return;
    const int before = pagesHeight();
    const int own = height() - before;
    // The pages keep the height of the smallest window, for which they are made.
    const int spare = height() - std::max(needs().height() - own, scaled(kMin.height()));
    const bool fits = fits_ && !scroll_ && spare >= scaled(kDockLeast);
    if (docked_ && fits) dock_->setFixedHeight(std::min(spare, scaled(kDockMost)));
    dock_->setVisible(docked_ && fits);
    if (fits_ && pagesHeight() != before) arrange();
}

}  // namespace terratact
