#include "widgets/control/angle_gauge.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr double kBeyond = 1.15;  // end of the scale, as a multiple of the red limit

}  // namespace

void drawAngleGauge(QPainter& painter, const QRectF& area,
                    const std::optional<DriveViewState::Angle>& angle, const QColor& ink)
{
    const double reach = area.width() / 2.0, half = area.height() / 2.0;
    const double zero = area.center().x(), line = area.center().y();
    painter.setPen(QPen(ink, 1.0));
    painter.drawLine(QPointF(area.left(), line), QPointF(area.right(), line));
    painter.drawLine(QPointF(zero, area.top()), QPointF(zero, area.bottom()));
    if (!angle || !(angle->limits.red > 0.0) || !std::isfinite(angle->angle)) return;
    const double scale = reach / (kBeyond * angle->limits.red);
    const auto tick = [&](double at, double high, double thick) {
        painter.fillRect(QRectF(zero + at * scale - thick / 2.0, line - high, thick, 2.0 * high),
                         ink);
    };
    for (const double sign : {-1.0, 1.0}) {
        tick(sign * angle->limits.amber, half * 0.7, 1.0);
        tick(sign * angle->limits.red, half, 2.0);
    }
    const double end = std::clamp(angle->angle * scale, -reach, reach);
    painter.fillRect(QRectF(zero + std::min(end, 0.0), line - half * 0.5, std::abs(end), half),
                     ink);
}

}  // namespace terratact
