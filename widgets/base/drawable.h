#pragma once

#include <QPainterPath>
#include <QPointF>
#include <cmath>
#include <vector>

namespace terratact {

/// The only way of a number into a plot.  One NaN in an antialiased wide curve blocks Qt's raster engine
/// for seconds, and so do coordinates far off the canvas; such a value is not drawable.
inline constexpr double kDrawableLimit =
    100.0;  ///< [m] or [N·10⁻¹]: far beyond any sensible picture
inline bool drawable(double value)
{
    return std::isfinite(value) && std::abs(value) <= kDrawableLimit;
}
inline bool drawable(QPointF point)
{
    return drawable(point.x()) && drawable(point.y());
}

/// The line through the drawable points; it breaks where one is not.
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
