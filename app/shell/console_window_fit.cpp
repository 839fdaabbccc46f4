#include <QApplication>
#include <QBoxLayout>
#include <QEvent>
#include <QLayout>
#include <QScreen>
#include <QScrollArea>
#include <algorithm>

#include "app/shell/console_window.h"
#include "app/shell/font_fit.h"
#include "app/shell/preferences/preferences.h"
#include "widgets/base/hidden_pages.h"
#include "widgets/base/theme.h"
#include "widgets/control/status_header.h"

// Fits the font and the window to the screen.

namespace terratact {

void ConsoleWindow::setRoom(QSize room)
{
    room_ = room;
    fitFont();
}

void ConsoleWindow::setLook(ThemeName theme, int wanted)
{
    const bool sameFont = wanted == wanted_ && fits_;
    if (theme == theme_ && wanted == wanted_) return arrange();
    theme_ = theme;
    wanted_ = wanted;
    if (!sameFont) {
        trying_ = largestToTry();
        return fitFontInTurns();
    }
    // Themes do not differ in size.
    applyLook(*qApp, theme_, lookInForce().fontScale);
    arrange();
}

QSize ConsoleWindow::frame() const
{
    return frameGeometry().size() - size();
}

void ConsoleWindow::fitToFrame()
{
    if (!fits_ || frame() == frame_) return;
    trying_ = largestToTry();
    fitFontInTurns();
}

QSize ConsoleWindow::room() const
{
    return room_.isValid() ? room_ : screen()->availableSize() - frame();
}

QSize ConsoleWindow::needs() const
{
    QSize now = layout()->totalMinimumSize();
    if (scroll_)
        now = {std::max(now.width(), below_->minimumSizeHint().width()),
               now.height() - scroll_->minimumSizeHint().height()
                   + below_->minimumSizeHint().height()};
    int height =
        now.height() + header_->heightFor(room().width()) - header_->minimumSizeHint().height();
    if (banners_->isEmpty()) height += bannerLine();
    return {now.width(), height};
}

void ConsoleWindow::setLeast(QSize needed)
{
    setMinimumSize(needed.expandedTo(kMin).boundedTo(room()));
    letScroll(needed.expandedTo(room()) != room());
}

void ConsoleWindow::letScroll(bool scrolls)
{
    if (scrolls == (scroll_ != nullptr)) return;
    auto* all = static_cast<QBoxLayout*>(layout());
    all->removeWidget(belowBanners());
    if (scrolls) {
        scroll_ = new QScrollArea(this);
        scroll_->setFrameShape(QFrame::NoFrame);
        scroll_->setFocusPolicy(Qt::NoFocus);
        scroll_->setWidgetResizable(true);
        scroll_->setWidget(below_);
    } else {
        scroll_->takeWidget();
        scroll_->hide();
        scroll_->deleteLater();
        scroll_ = nullptr;
    }
    all->addWidget(belowBanners(), 1);
    below_->show();
    belowBanners()->show();
}

QWidget* ConsoleWindow::belowBanners() const
{
    return scroll_ ? scroll_ : below_;
}

int ConsoleWindow::bannerLine() const
{
    return banners_->count() > 0 ? banners_->itemAt(0)->widget()->sizeHint().height() : 0;
}

int ConsoleWindow::bannersHeight() const
{
    int strips = 0;
    for (int i = 0; i < strips_->count(); ++i)
        if (const QWidget* strip = strips_->itemAt(i)->widget(); strip && !strip->isHidden())
            strips += strip->height();
    return std::max(0, belowBanners()->y() - header_->y() - header_->height() - strips);
}

QSize ConsoleWindow::roomBelowHeader()
{
    finishFitting();
    // Both windows have the same frame.
    return size() - QSize(0, header_->geometry().bottom() + 1 + bannerLine()) - frame();
}

void ConsoleWindow::putBelowHeader(QWidget& other)
{
    const QSize room = roomBelowHeader();
    other.resize(other.size().boundedTo(room));
    const QSize spare = room - other.size();
    const QPoint corner = mapToGlobal(QPoint(0, height() - room.height() - frame().height()));
    other.move(corner + QPoint(spare.width() / 2, spare.height() / 2));
}

int ConsoleWindow::largestToTry() const
{
    const bool known = tooLarge_ && tooLarge_->room == room()
                    && tooLarge_->arrangement == arrangement() && tooLarge_->percent <= wanted_;
    return known ? std::max(tooLarge_->percent - kFontStep, kSmallestFont) : wanted_;
}

void ConsoleWindow::fitFont()
{
    trying_ = largestToTry();
    applyTried();
    fitAtOnce();
}

void ConsoleWindow::finishFitting()
{
    if (tryLater_.isActive()) fitAtOnce();
}

void ConsoleWindow::fitAtOnce()
{
    tryLater_.stop();
    styleHiddenPages();
    while (!triedFits()) {
        applyTried();
        styleHiddenPages();
    }
}

void ConsoleWindow::fitFontInTurns()
{
    setUpdatesEnabled(false);  // hides the intermediate font sizes
    applyTried();
    tryLater_.start(0);
}

void ConsoleWindow::fitInThisTurn()
{
    constexpr int kTurn = 5;  // [ms]
    // The window has the size that the largest of its pages needs, so all of them count.
    if (!styleHiddenPages(kTurn)) return tryLater_.start(0);
    if (!triedFits()) fitFontInTurns();
}

void ConsoleWindow::applyTried()
{
    fits_ = false;  // fitting is in progress
    frame_ = frame();
    tryLater_.stop();
    if (dock_) dock_->hide();
    letScroll(false);
    if (trying_ != lookInForce().fontScale || theme_ != lookInForce().theme)
        applyLook(*qApp, theme_, trying_);
}

bool ConsoleWindow::triedFits()
{
    layOutAnew();
    const QSize needed = needs();
    if (needed.expandedTo(room()) != room()) {
        tooLarge_ = TooLarge{trying_, room(), arrangement()};
        if (trying_ > kSmallestFont) {
            trying_ = smallerFont(trying_, needed, room());
            return false;
        }
    }
    setLeast(needed);
    layOutAnew();
    fits_ = true;
    arrange();
    keepOnScreen();
    placeDock();
    setUpdatesEnabled(true);
    // A repaint that was due while updates were off is dropped, and Qt then waits for it forever.
    QCoreApplication::postEvent(this, new QEvent(QEvent::UpdateRequest), Qt::LowEventPriority);
    return true;
}

void ConsoleWindow::layOutAnew()
{
    arrange();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    forgetSizes(*this);
}

/// Moves the window back if it grew over the screen's edge, where STOP would be out of reach.
void ConsoleWindow::keepOnScreen()
{
    if (!isVisible() || isMaximized() || isFullScreen()) return;
    const QRect screenArea = screen()->availableGeometry();
    QRect frame = frameGeometry();
    if (frame.size().expandedTo(screenArea.size()) != screenArea.size()) {
        if (room_.isValid() || screen()->availableVirtualGeometry().contains(frame)) return;
        resize(size().boundedTo(room()));
        frame = frameGeometry();
    }
    frame.moveRight(std::min(frame.right(), screenArea.right()));
    frame.moveBottom(std::min(frame.bottom(), screenArea.bottom()));
    frame.moveLeft(std::max(frame.left(), screenArea.left()));
    frame.moveTop(std::max(frame.top(), screenArea.top()));
    if (frame.topLeft() != frameGeometry().topLeft()) move(frame.topLeft());
}

}  // namespace terratact
