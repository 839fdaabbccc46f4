#pragma once

#include <QPainterPath>
#include <QPointF>
#include <cmath>
#include <vector>

namespace terratact {

/// Numbers pass this check before they enter a plot. One NaN in an antialiased wide curve blocks Qt's raster engine for
/// seconds; coordinates far outside the canvas do, too. Such a value is not drawable.
/// [m] or [N·10⁻¹]: far beyond any sensible picture.
inline constexpr double kDrawableLimit = 100.0;
inline bool drawable(double value)
{
    return std::isfinite(value) && std::abs(value) <= kDrawableLimit;
}
inline bool drawable(QPointF point)
{
    return drawable(point.x()) && drawable(point.y());
}

/// Returns the line through the drawable points; it breaks where a point is not drawable.
inline QPainterPath pathThrough(const std::vector<QPointF>& points)
{
    QPainterPath path;
    bool pen = false;
    for (const QPointF& point : points) {
        if (!drawable(point)) {
            pen = false;
        } else if (pen) {
            path.lineTo(point);
        } else {
            path.moveTo(point);
            pen = true;
        }
    }
    return path;
}

}  // namespace terratact
