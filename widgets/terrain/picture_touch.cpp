#include "widgets/terrain/picture_touch.h"

#include <QApplication>
#include <QLineF>
#include <QTouchEvent>
#include <QWidget>
#include <utility>

#include "widgets/base/palette.h"

namespace terratact {

PictureTouch::PictureTouch(QWidget& widget, PictureGestures gestures)
    : QObject(&widget), widget_(widget), gestures_(std::move(gestures))
{
    widget.setAttribute(Qt::WA_AcceptTouchEvents);
    widget.installEventFilter(this);
    long_.setSingleShot(true);
    long_.setInterval(kLong);
    connect(&long_, &QTimer::timeout, this, [this] {
        if (doing_ != Doing::Pressed) return;
        doing_ = Doing::Hovering;
        gestures_.hovered(last_);
    });
}

bool PictureTouch::eventFilter(QObject* object, QEvent* event)
{
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
        handle(static_cast<const QTouchEvent&>(*event));
        event->accept();
        return true;
    case QEvent::TouchCancel:
        letGo();
        event->accept();
        return true;
    default: return QObject::eventFilter(object, event);
    }
}

void PictureTouch::handle(const QTouchEvent& event)
{
    QList<QPointF> down;
    QPointF lifted = last_;
    for (const QEventPoint& point : event.points()) {
        if (point.state() == QEventPoint::Released)
            lifted = point.position();
        else
            down << point.position();
    }
    if (down.size() >= 2) {
        const Fingers now{(down[0] + down[1]) / 2.0, QLineF(down[0], down[1]).length()};
        if (fingers_) {
            const double least = scaled(kApart);
            const bool zooms = fingers_->apart >= least && now.apart >= least;
            gestures_.pinched(zooms ? now.apart / fingers_->apart : 1.0, fingers_->middle,
                              now.middle);
        } else {
            letGo();
        }
        doing_ = Doing::Pinching;
        fingers_ = now;
        return;
    }
    fingers_.reset();
    if (down.isEmpty()) return end(lifted);
    // The finger that stays after a pinch does nothing until it is lifted.
    if (doing_ == Doing::Nothing) return begin(down[0]);
    move(down[0]);
}

void PictureTouch::begin(QPointF at)
{
    doing_ = Doing::Pressed;
    began_ = last_ = at;
    long_.start();
    gestures_.pressed(at);
}

void PictureTouch::move(QPointF at)
{
    last_ = at;
    if (doing_ == Doing::Pressed && QLineF(began_, at).length() >= scaled(kStill))
        doing_ = Doing::Dragging;
    if (doing_ == Doing::Dragging) gestures_.moved(at);
    if (doing_ == Doing::Hovering) gestures_.hovered(at);
}

void PictureTouch::end(QPointF at)
{
    const Doing did = doing_;
    letGo();
    if (did != Doing::Pressed) return;
    const bool isSecond = sinceTap_.isValid()
                       && sinceTap_.elapsed() <= QApplication::doubleClickInterval()
                       && QLineF(tappedAt_, at).length() <= 2.0 * scaled(kStill);
    if (isSecond) {
        sinceTap_.invalidate();
        return gestures_.tappedTwice(at);
    }
    sinceTap_.start();
    tappedAt_ = at;
    gestures_.tapped(at);
}

/// Ends a press or a drag of one finger.
void PictureTouch::letGo()
{
    long_.stop();
    if (doing_ == Doing::Pressed || doing_ == Doing::Dragging) gestures_.released(last_);
    doing_ = Doing::Nothing;
    fingers_.reset();
}

}  // namespace terratact
