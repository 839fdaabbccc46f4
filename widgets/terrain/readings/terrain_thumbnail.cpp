#include "widgets/terrain/readings/terrain_thumbnail.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "core/infer/estimate/two_track_estimate.h"
#include "core/terrain/bins.h"
#include "widgets/base/palette.h"

namespace terratact {
namespace {

constexpr int kLastUnderRobot = 5;  // bin at +0.2 m

/// Returns the mean estimated height of the ground under the robot [m].
double groundOf(const TwoTrackEstimate& estimate)
{
    double sum = 0.0;
    int count = 0;
    for (const TerrainEstimate& side : estimate.side)
        for (std::size_t i = 0; i <= kLastUnderRobot; ++i)
            if (std::isfinite(side.height[i])) {
                sum += side.height[i];
                ++count;
            }
    return count > 0 ? sum / count : 0.0;
}

/// Maps metres to the area of a thumbnail.
struct ThumbnailScale {
    QRectF area;
    double ground;

    double x(double metres) const
    {
        return area.left()
             + area.width() * (metres - binBegin(0)) / (binEnd(kBins - 1) - binBegin(0));
    }
    /// The ground is below the middle: more rises than falls are of interest.
    double y(double metres) const
    {
        const double share = (metres - ground) / kThumbnailSpan + 0.4;
        return area.bottom() - area.height() * std::clamp(share, -1.0, 2.0);
    }
    QPointF at(std::size_t bin, double metres) const
    {
        return {x(binCentre(static_cast<int>(bin))), y(metres)};
    }
};

void drawSide(QPainter& painter, const ThumbnailScale& scale, const TerrainEstimate& side,
              Qt::PenStyle style)
{
    QPolygonF band, line;
    for (std::size_t i = 0; i < kBins; ++i) band << scale.at(i, side.q90[i]);
    for (std::size_t i = kBins; i-- > 0;) band << scale.at(i, side.q10[i]);
    for (std::size_t i = 0; i < kBins; ++i) line << scale.at(i, side.height[i]);
    QColor filled = theme().sampled;
    filled.setAlphaF(0.28F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(filled);
    painter.drawPolygon(band);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().sampled, 1.6, style));
    painter.drawPolyline(line);
    painter.setPen(Qt::NoPen);
    for (std::size_t i = 0; i < kBins; ++i) {
        if (side.origin[i] == Origin::Sampled) continue;
        painter.setBrush(side.origin[i] == Origin::Arm ? theme().arm : theme().contact);
        const QPointF at = scale.at(i, side.height[i]);
        painter.drawRect(QRectF(at.x() - 2.0, at.y() - 2.0, 4.0, 4.0));
    }
}

}  // namespace

void drawTerrainThumbnail(QPainter& painter, const QRectF& area, const TwoTrackEstimate& estimate)
{
    painter.save();
    painter.setClipRect(area);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(area, theme().card);
    const ThumbnailScale scale{area, groundOf(estimate)};
    painter.setPen(QPen(theme().grid, 1.0));
    painter.drawLine(QPointF(area.left(), scale.y(scale.ground)),
                     QPointF(area.right(), scale.y(scale.ground)));
    if (!estimate.onePlane) drawSide(painter, scale, estimate.side[1], Qt::DashLine);
    drawSide(painter, scale, estimate.side[0], Qt::SolidLine);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().cardBorder, 1.0));
    painter.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5));
    painter.restore();
}

}  // namespace terratact
