#include "widgets/terrain/robot_sketch.h"

#include <qwt_plot.h>
#include <qwt_plot_shapeitem.h>

#include <QPen>

#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"

namespace terratact {
namespace {

QColor fillOf(OutlinePart::Kind kind)
{
    switch (kind) {
    case OutlinePart::Kind::Body: return theme().robotBody;
    case OutlinePart::Kind::Track: return theme().robotTrack;
    case OutlinePart::Kind::FrontFlipper:
    case OutlinePart::Kind::RearFlipper: return theme().robotFlipper;
    }
    return {};
}

QPainterPath pathOf(const OutlinePart& part)
{
    std::vector<QPointF> corners;
    for (const auto& [x, z] : part.points)
        if (drawable(QPointF(x, z))) corners.emplace_back(x, z);
    QPainterPath path = pathThrough(corners);
    if (!path.isEmpty()) path.closeSubpath();
    return path;
}

}  // namespace

QwtPlotShapeItem* RobotSketch::newPart()
{
    auto* part = new QwtPlotShapeItem;
    part->setItemAttribute(QwtPlotItem::Legend, false);
    part->setRenderHint(QwtPlotItem::RenderAntialiased);
    part->setZ((isFar_ ? 4.0 : 5.0) + 0.01 * static_cast<double>(parts_.size()));
    part->attach(&plot_);
    return part;
}

void RobotSketch::setOutline(const Outline& outline)
{
    outline_ = outline;
    while (parts_.size() < outline.size()) parts_.push_back(newPart());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (i >= outline.size()) {
            parts_[i]->setShape({});
            continue;
        }
        QColor fill = fillOf(outline[i].kind);
        fill.setAlpha(isFar_ ? 0x50 : 0xd0);
        parts_[i]->setBrush(fill);
        parts_[i]->setPen(QPen(theme().robotLine, 1.0, isFar_ ? Qt::DashLine : Qt::SolidLine));
        parts_[i]->setShape(pathOf(outline[i]));
    }
}

}  // namespace terratact
