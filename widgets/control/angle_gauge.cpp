#include "widgets/control/angle_gauge.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/base/palette.h"

namespace terratact {
namespace {

constexpr int kHigh = 7;          // [px at 100 %]
constexpr double kBeyond = 1.15;  // end of the scale, as a multiple of the red limit

}  // namespace

AngleGauge::AngleGauge(QWidget* parent) : QWidget(parent) {}

QSize AngleGauge::sizeHint() const
{
    return {scaledLarge(40), scaledLarge(kHigh)};
}

void AngleGauge::setAngle(const std::optional<DriveViewState::Angle>& angle)
{
    if (angle == angle_) return;
    angle_ = angle;
    update();
}

void AngleGauge::setInk(const QColor& ink)
{
    if (ink == ink_) return;
    ink_ = ink;
    update();
}

void AngleGauge::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QColor& ink = ink_;
    const double middle = width() / 2.0, line = height() / 2.0;
    painter.setPen(QPen(ink, 1.0));
    painter.drawLine(QPointF(0.0, line), QPointF(width(), line));
    painter.drawLine(QPointF(middle, 0.0), QPointF(middle, height()));
    if (!angle_ || !(angle_->limits.red > 0.0) || !std::isfinite(angle_->angle)) return;
    const double scale = middle / (kBeyond * angle_->limits.red);
    const auto tick = [&](double at, double half, double thick) {
        painter.fillRect(QRectF(middle + at * scale - thick / 2.0, line - half, thick, 2.0 * half),
                         ink);
    };
    for (const double sign : {-1.0, 1.0}) {
        tick(sign * angle_->limits.amber, line * 0.7, 1.0);
        tick(sign * angle_->limits.red, line, 2.0);
    }
    const double end = std::clamp(angle_->angle * scale, -middle, middle);
    painter.fillRect(QRectF(middle + std::min(end, 0.0), line - line * 0.5, std::abs(end), line),
                     ink);
}

}  // namespace terratact
