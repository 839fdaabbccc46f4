#include "widgets/base/held_button.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "widgets/base/palette.h"

namespace terratact {
namespace {

constexpr int kFrame = 6;                    // [px] between the edge and the text
constexpr double kRound = 5.0, kRing = 4.0;  // [px] corner radius, width of the ring

/// Paints the share 0 … 1 of a ring, clockwise from the middle of the top.
void paintRing(QPainter& painter, const QRectF& area, double share, const QColor& colour)
{
    const QRectF way = area.adjusted(kRing / 2, kRing / 2, -kRing / 2, -kRing / 2);
    const QPointF top(way.center().x(), way.top());
    QPainterPath ring(top);
    const auto corner = [&](double x, double y, double angle) {
        ring.arcTo(QRectF(x, y, 2 * kRound, 2 * kRound), angle, -90.0);
    };
    corner(way.right() - 2 * kRound, way.top(), 90.0);
    corner(way.right() - 2 * kRound, way.bottom() - 2 * kRound, 0.0);
    corner(way.left(), way.bottom() - 2 * kRound, -90.0);
    corner(way.left(), way.top(), 180.0);
    ring.lineTo(top);
    QPen pen(colour, kRing, Qt::CustomDashLine, Qt::FlatCap);
    const double length = ring.length() / kRing;  // dash lengths are in units of the pen's width
    pen.setDashPattern({std::max(1e-3, share * length), length});
    painter.strokePath(ring, pen);
}

}  // namespace

HeldButton::HeldButton(const QString& text, QWidget* parent) : QPushButton(text, parent)
{
    // Clicks do not take the focus, because Space would then press this button.
    setFocusPolicy(Qt::TabFocus);
    release_.setSingleShot(true);
    release_.setInterval(40);
    connect(&release_, &QTimer::timeout, this, &HeldButton::letGo);
}

void HeldButton::hold()
{
    release_.stop();
    if (held_ || !isEnabled() || !isVisible() || !mayHold()) return;
    held_ = true;
    setDown(true);
    emit holdBegan();
}

void HeldButton::letGoSoon()
{
    if (held_ && !release_.isActive()) release_.start();
}

void HeldButton::letGo()
{
    release_.stop();
    if (!held_) return;
    held_ = false;
    setDown(false);
    emit holdEnded();
}

void HeldButton::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) hold();
}

void HeldButton::mouseMoveEvent(QMouseEvent* event)
{
    if (!rect().contains(event->position().toPoint())) letGo();
}

void HeldButton::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) letGo();
}

void HeldButton::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space) {
        if (!event->isAutoRepeat()) hold();
    } else {
        event->ignore();
    }
}

void HeldButton::keyReleaseEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space) {
        if (!event->isAutoRepeat()) letGoSoon();
    } else {
        event->ignore();
    }
}

void HeldButton::focusOutEvent(QFocusEvent* event)
{
    QPushButton::focusOutEvent(event);
    letGo();
}

void HeldButton::hideEvent(QHideEvent* event)
{
    QPushButton::hideEvent(event);
    letGo();
}

void HeldButton::changeEvent(QEvent* event)
{
    QPushButton::changeEvent(event);
    if (event->type() == QEvent::EnabledChange && !isEnabled()) letGo();
}

bool HeldButton::event(QEvent* event)
{
    if (event->type() == QEvent::WindowDeactivate) letGo();
    return QPushButton::event(event);
}

HoldToConfirmButton::HoldToConfirmButton(const QString& text, Fill Theme::*fill, QWidget* parent)
    : HeldButton(text, parent), fill_(fill)
{
    frames_.setInterval(16);
    connect(this, &HeldButton::holdBegan, this, [this] {
        heldFor_ = 0;
        lastFrame_.start();
        frames_.start();
        update();
    });
    connect(this, &HeldButton::holdEnded, this, [this] {
        frames_.stop();
        update();
    });
    connect(&frames_, &QTimer::timeout, this, &HoldToConfirmButton::advance);
}

double HoldToConfirmButton::share() const
{
    if (!isHeld()) return 0.0;
    return std::min(1.0, static_cast<double>(heldFor_) / std::max(1, holdTime_));
}

void HoldToConfirmButton::advance()
{
    // After a freeze, the release event may still wait in the queue behind this timer.
    constexpr qint64 kMaxFrameLength = 50;
    if (!mayHold()) return letGo();
    heldFor_ += std::min(lastFrame_.restart(), kMaxFrameLength);
    update();
    if (share() < 1.0) return;
    letGo();
    emit confirmed();
}

QSize HoldToConfirmButton::sizeHint() const
{
    // The height stays below that of STOP, so that the header keeps its height.
    return {fontMetrics().horizontalAdvance(text()) + scaled(36), scaled(40)};
}

QSize HoldToConfirmButton::minimumSizeHint() const
{
    const QFontMetrics metrics(boldFont());
    int width = metrics.horizontalAdvance(text());
    for (qsizetype space = text().indexOf(u' '); space > 0; space = text().indexOf(u' ', space + 1))
        width = std::min(width, std::max(metrics.horizontalAdvance(text().left(space)),
                                         metrics.horizontalAdvance(text().mid(space + 1))));
    return {width + 2 * kFrame, std::max(scaled(40), 2 * metrics.lineSpacing() + kFrame)};
}

QFont HoldToConfirmButton::boldFont() const
{
    QFont bold = font();
    bold.setBold(true);
    return bold;
}

void HoldToConfirmButton::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = QRectF(rect()).adjusted(1, 1, -1, -1);
    QPainterPath shape;
    shape.addRoundedRect(area, kRound, kRound);
    const Fill fill = isEnabled() ? theme().*fill_ : theme().off;
    painter.fillPath(shape, fill.area);
    if (isHeld()) {
        painter.setClipPath(shape);
        const QRectF done(area.left(), area.top(), area.width() * share(), area.height());
        QColor filled = fill.text;
        filled.setAlphaF(0.25F);
        painter.fillRect(done, filled);
        painter.setClipping(false);
    }
    const QColor edge = isEnabled() ? theme().buttonBorder : theme().offBorder;
    painter.setPen(QPen(hasFocus() ? theme().text : edge, hasFocus() ? 2.5 : 1.0));
    painter.drawPath(shape);
    if (isHeld()) paintRing(painter, area, share(), fill.text);
    painter.setPen(fill.text);
    painter.setFont(isEnabled() ? boldFont() : font());
    painter.drawText(rect().adjusted(kFrame, 0, -kFrame, 0), Qt::AlignCenter | Qt::TextWordWrap,
                     text());
}

}  // namespace terratact
