#include "widgets/terrain/earlier_layer.h"

#include <qwt_plot.h>
#include <qwt_scale_map.h>

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/display/translated.h"
#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/profile_axes.h"
#include "widgets/terrain/remembered_layer.h"
#include "widgets/terrain/terrain_items.h"

namespace terratact {
namespace {

bool isEarlierDrawn(const EarlierBin& bin)
{
    return bin.felt != FeltBy::NotFelt && bin.sd <= RememberedLayer::kMaxSd && drawable(bin.height);
}

/// Returns the line through neighbouring points [m].
QPainterPath earlierLine(const std::vector<QPointF>& points)
{
    QPainterPath path;
    const QPointF* before = nullptr;
    for (const QPointF& point : points) {
        if (before && point.x() - before->x() < RememberedLayer::kNeighbour)
            path.lineTo(point);
        else
            path.moveTo(point);
        before = &point;
    }
    return path;
}

}  // namespace

EarlierLayer::EarlierLayer() : rear_(ProfileAxes::kLeft)
{
    setZ(10.0);
    setRenderHint(QwtPlotItem::RenderAntialiased);
    setItemAttribute(QwtPlotItem::Legend, false);
}

/// Returns a section with its front at `end`. It has no points if nothing of the section is drawn.
EarlierLayer::Stretch EarlierLayer::stretchOf(const EarlierSection& section, double end)
{
    Stretch stretch{.begin = end, .end = end, .next = section.next};
    double front = -std::numeric_limits<double>::infinity();
    const std::size_t sides = section.onePlane ? 1 : 2;
    for (std::size_t side = 0; side < sides; ++side)
        for (const EarlierBin& bin : section.side.at(side))
            if (isEarlierDrawn(bin)) front = std::max(front, bin.x);
    for (std::size_t side = 0; side < sides; ++side)
        for (const EarlierBin& bin : section.side.at(side)) {
            if (!isEarlierDrawn(bin)) continue;
            const double x = bin.x - front + end;
            stretch.side.at(side).emplace_back(x, bin.height);
            stretch.begin = std::min(stretch.begin, x);
        }
    return stretch;
}

void EarlierLayer::setSections(const std::vector<EarlierSection>& sections)
{
    sections_ = sections;
    stretches_.clear();
    double rear = 0.0;
    for (const EarlierSection& section : sections) {
        Stretch stretch = stretchOf(section, rear - kGap);
        if (stretch.side[0].empty() && stretch.side[1].empty()) continue;
        rear = stretch.begin;
        stretches_.push_back(std::move(stretch));
    }
}

std::vector<QPointF> EarlierLayer::within(double left, double right) const
{
    std::vector<QPointF> points;
    for (const Stretch& stretch : stretches_)
        for (const auto& side : stretch.side)
            for (const QPointF& point : side)
                if (const double x = rear_ + point.x(); x >= left && x <= right)
                    points.emplace_back(x, point.y());
    return points;
}

void EarlierLayer::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                        const QRectF& canvas) const
{
    const QTransform pixels(x.transform(1.0) - x.transform(0.0), 0.0, 0.0,
                            y.transform(1.0) - y.transform(0.0), x.transform(rear_),
                            y.transform(0.0));
    for (const Stretch& stretch : stretches_) {
        painter->setBrush(Qt::NoBrush);
        painter->setPen(QPen(theme().muted, 1.0));
        for (const auto& side : stretch.side) painter->drawPath(pixels.map(earlierLine(side)));
        drawRule(*painter, stretch, x, canvas);
    }
}

/// Draws the rule in front of a stretch. The words stand upright behind it, where the gap has room for them.
void EarlierLayer::drawRule(QPainter& painter, const Stretch& stretch, const QwtScaleMap& x,
                            const QRectF& canvas) const
{
    const double at = x.transform(rear_ + stretch.end + kGap / 2.0);
    painter.setPen(QPen(theme().muted, 1.0, Qt::DashLine));
    painter.drawLine(QPointF(at, canvas.top()), QPointF(at, canvas.bottom()));
    painter.setFont(sized(plot()->font(), 12));
    const QFontMetrics metrics = painter.fontMetrics();
    if (at - x.transform(rear_ + stretch.end) < metrics.height()) return;
    const QString words =
        QCoreApplication::translate("terratact::TerrainProfileView", "earlier: %1")
            .arg(translated(describe(stretch.next)));
    painter.save();
    painter.translate(at, canvas.center().y());
    painter.rotate(-90.0);
    const QRectF place(-canvas.height() / 2.0, -metrics.height(), canvas.height(),
                       metrics.height());
    painter.drawText(place, Qt::AlignCenter,
                     metrics.elidedText(words, Qt::ElideRight, static_cast<int>(place.width())));
    painter.restore();
}

}  // namespace terratact
