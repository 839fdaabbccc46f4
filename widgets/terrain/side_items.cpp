#include "widgets/terrain/side_items.h"

#include <qwt_graphic.h>
#include <qwt_plot.h>
#include <qwt_scale_map.h>
#include <qwt_text.h>

#include <QPainter>
#include <algorithm>
#include <utility>

#include "app/display/place_text.h"
#include "core/infer/estimate/provenance.h"
#include "core/infer/verdict/verdict.h"
#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/provenance_marks.h"
#include "widgets/terrain/terrain_items.h"

namespace terratact {
namespace {

constexpr double kDash = 7.5;  // [px] length of a dash and of a gap

}  // namespace

QColor lightened(const QColor& colour)
{
    constexpr double kCard = 0.35;  // share of the card's colour
    const QColor card = theme().card;
    const auto mix = [](int own, int behind) {
        return static_cast<int>((1.0 - kCard) * own + kCard * behind);
    };
    return {mix(colour.red(), card.red()), mix(colour.green(), card.green()),
            mix(colour.blue(), card.blue())};
}

QPen sideLinePen(const QColor& colour, double width)
{
    return {colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

QPen sidePriorPen(const QColor& colour, double width)
{
    QPen pen(colour, width, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    pen.setDashPattern({kDash / width, kDash / width});  // in widths of the pen
    return pen;
}

void drawSideLine(QPainter& painter, const QPainterPath& path, Side side, const QColor& colour,
                  bool dashed)
{
    painter.setBrush(Qt::NoBrush);
    const bool isHollow = side == Side::Left;
    const auto pen = dashed ? sidePriorPen : sideLinePen;
    painter.strokePath(path, pen(colour, isHollow ? kHollowLine : kSideLine));
    if (isHollow) painter.strokePath(path, pen(theme().card, kHollowCore));
}

LightSide::LightSide()
{
    setZ(16.0);
    setRenderHint(QwtPlotItem::RenderAntialiased);
    setItemAttribute(QwtPlotItem::Legend, false);
}

void LightSide::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                     const QRectF& /*canvas*/) const
{
    if (!estimate) return;
    drawLines(*painter, x, y);
    drawBins(*painter, x, y);
}

void LightSide::drawLines(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y) const
{
    const auto pointOf = [&](int bin) {
        return QPointF(x.transform(binCentre(bin) + aside()),
                       y.transform(estimate->height[static_cast<std::size_t>(bin)]));
    };
    const auto segment = [&](QPainterPath& path, int bin) {
        const auto i = static_cast<std::size_t>(bin);
        if (!drawable(estimate->height[i - 1]) || !drawable(estimate->height[i])) return;
        const QPointF from = pointOf(bin - 1);
        if (path.isEmpty() || path.currentPosition() != from) path.moveTo(from);
        path.lineTo(pointOf(bin));
    };
    QPainterPath solid, soft;
    for (int bin = 1; bin < kBins; ++bin)
        segment(estimate->priorOnly(bin) || estimate->priorOnly(bin - 1) ? soft : solid, bin);
    const QColor colour = lightened(theme().sampled);
    drawSideLine(painter, soft, side, colour, true);
    drawSideLine(painter, solid, side, colour, false);
}

void LightSide::drawBins(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y) const
{
    constexpr double kSmall = 0.62;  // size of a mark and of a bar's ends
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        const ProvenanceMark mark = markOf(provenance(*estimate, bin));
        const double at = x.transform(binCentre(bin) + aside());
        const bool hasBand = !isUnfeltAhead(*estimate, bin) && drawable(estimate->q10[i])
                          && drawable(estimate->q90[i]) && estimate->q10[i] <= estimate->q90[i];
        if (hasBand) {
            QPen pen(mark.bar);
            pen.setColor(lightened(mark.line));
            pen.setWidthF(std::min(pen.widthF(), 2.0));
            PatternBar bar(pen);
            bar.setWidth(static_cast<int>(kSmall * bar.width()));
            bar.draw(&painter, Qt::Vertical, {at, y.transform(estimate->q10[i])},
                     {at, y.transform(estimate->q90[i])});
        }
        if (!drawable(estimate->height[i])) continue;
        const int size = static_cast<int>(kSmall * scaled(mark.size));
        const QColor ink = lightened(mark.line);
        const QwtSymbol symbol(mark.shape, brushOf(markFill(*estimate, bin), ink), QPen(ink, 1.5),
                               QSize(size, size));
        symbol.drawSymbol(&painter, {at, y.transform(estimate->height[i])});
    }
}

SideTags::SideTags()
{
    setZ(32.0);
    setItemAttribute(QwtPlotItem::Legend, false);
}

void SideTags::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                    const QRectF& canvas) const
{
    painter->setFont(sized(plot()->font(), 13, true));
    const double width = painter->fontMetrics().horizontalAdvance(QLatin1Char('M')) + scaled(4);
    const double height = painter->fontMetrics().height();
    for (const bool isFront : {false, true}) {
        std::vector<std::pair<QRectF, const Tag*>> places;
        for (const Tag& tag : tags) {
            const QPointF end = isFront ? tag.front : tag.rear;
            if (!drawable(end)) continue;
            const double wanted = x.transform(end.x()) + (isFront ? 1.0 : -1.0) * scaled(22);
            const double centre = std::clamp(
                wanted, canvas.left() + width / 2.0 + 1.0,
                std::max(canvas.left() + width / 2.0 + 1.0, canvas.right() - width / 2.0 - 1.0));
            QRectF place(centre - width / 2.0, y.transform(end.y()) - height / 2.0, width, height);
            place.moveTop(std::clamp(place.top(), canvas.top(),
                                     std::max(canvas.top(), canvas.bottom() - height)));
            places.emplace_back(place, &tag);
        }
        if (places.size() == 2) {  // the higher one moves up, the lower one down
            const bool isFirstHigher = places[0].first.top() <= places[1].first.top();
            QRectF& high = places[isFirstHigher ? 0 : 1].first;
            QRectF& low = places[isFirstHigher ? 1 : 0].first;
            if (const double lack = height + 1.0 - (low.top() - high.top()); lack > 0.0) {
                high.translate(0.0, -lack / 2.0);
                low.translate(0.0, lack / 2.0);
            }
        }
        for (const auto& [place, tag] : places) {
            const QColor colour = tag->isFull ? theme().sampled : lightened(theme().sampled);
            painter->setPen(QPen(colour, 1.5));
            painter->setBrush(tag->isFull ? colour : theme().card);
            painter->drawRect(place);
            painter->setPen(tag->isFull ? theme().card : theme().text);
            painter->drawText(place, Qt::AlignCenter, sideLetter(tag->side));
        }
    }
}

SideKey::SideKey(Side side)
    : QwtPlotItem(QwtText(sideLetter(side) + QStringLiteral(": ") + sideWord(side))), side_(side)
{
    setItemAttribute(QwtPlotItem::Legend, false);
}

void SideKey::draw(QPainter* /*painter*/, const QwtScaleMap& /*x*/, const QwtScaleMap& /*y*/,
                   const QRectF& /*canvas*/) const
{
}

QwtGraphic SideKey::legendIcon(int /*index*/, const QSizeF& /*size*/) const
{
    QwtGraphic icon;
    icon.setDefaultSize(QSizeF(26, 16));
    QPainter painter(&icon);
    QPainterPath path(QPointF(3, 8));
    path.lineTo(23, 8);
    drawSideLine(painter, path, side_, theme().sampled, false);
    return icon;
}

}  // namespace terratact
