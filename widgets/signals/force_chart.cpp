#include "widgets/signals/force_chart.h"

#include <qwt_scale_map.h>
#include <qwt_text.h>

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "widgets/base/palette.h"
#include "widgets/signals/force_bars.h"

namespace terratact {
namespace {

constexpr double kGroup = 0.76;  // share of an element's width
constexpr double kGap = 0.06;    // between the bars of a group

constexpr std::array kArrayLooks{
    ArrayLook{u'■', false, Qt::NoBrush}, ArrayLook{u'□', true, Qt::NoBrush},
    ArrayLook{u'▦', true, Qt::CrossPattern}, ArrayLook{u'▤', true, Qt::HorPattern}};

/// Fills a bar in contact: its own colour, hatched.
void fill(QPainter& painter, const QRectF& rect, const ForceChart::Bar& bar)
{
    const QColor colour = bar.touching ? theme().contact : theme().force;
    const bool outlined = bar.look.outlined;
    QColor hatch = outlined ? colour : theme().card;
    hatch.setAlpha(outlined ? 200 : 110);
    painter.fillRect(rect, outlined ? theme().card : colour);
    if (bar.look.pattern != Qt::NoBrush) painter.fillRect(rect, QBrush(colour, bar.look.pattern));
    if (bar.touching) painter.fillRect(rect, QBrush(hatch, Qt::BDiagPattern));
    if (!outlined) return;
    constexpr double kPen = 2.0;
    painter.setPen(QPen(colour, kPen));
    painter.setBrush(Qt::NoBrush);
    if (rect.height() > 2.0 * kPen)
        painter.drawRect(rect.adjusted(kPen / 2, kPen / 2, -kPen / 2, -kPen / 2));
    else
        painter.fillRect(rect, colour);
}

/// Draws the triangle of a saturated element at the top of its bar.
void mark(QPainter& painter, const QRectF& rect)
{
    const double half = std::min(5.0, rect.width() / 2.0 - 1.0);
    const QPointF top(rect.center().x(), rect.top() + 3.0);
    painter.setPen(QPen(theme().card, 1.0));
    painter.setBrush(theme().text);
    painter.drawPolygon(
        QPolygonF({top, top + QPointF(-half, 2.0 * half), top + QPointF(half, 2.0 * half)}));
}

}  // namespace

const ArrayLook& arrayLook(std::size_t array)
{
    return kArrayLooks[array % kArrayLooks.size()];
}

Span spanOf(int element, int place, int bars)
{
    const double width = (kGroup - kGap * (bars - 1)) / bars;
    const double left = element - kGroup / 2.0 + place * (width + kGap);
    return {left, left + width};
}

QRectF rectOf(Span span, double value, const QwtScaleMap& x, const QwtScaleMap& y)
{
    return QRectF(QPointF(x.transform(span.left), y.transform(std::max(0.0, value))),
                  QPointF(x.transform(span.right), y.transform(0.0)))
        .normalized();
}

ElementScale::ElementScale()
{
    enableComponent(QwtAbstractScaleDraw::Ticks, false);
    enableComponent(QwtAbstractScaleDraw::Backbone, true);
}

QwtText ElementScale::label(double value) const
{
    const auto index =
        static_cast<std::size_t>(std::clamp(std::lround(value), 0L, kForceElements - 1L));
    if (notes_[index].isEmpty()) return nameOf(static_cast<int>(index) + 1);
    QwtText text(notes_[index]);
    text.setColor(theme().warning);
    return text;
}

void ElementScale::setNotes(const std::array<QString, kForceElements>& notes)
{
    notes_ = notes;
    invalidateCache();
}

QString ElementScale::nameOf(int element)
{
    if (element == 1) return ForceBars::tr("1 pivot");
    if (element == kForceElements) return ForceBars::tr("%1 tip").arg(element);
    return QString::number(element);
}

void ElementScale::drawLabel(QPainter* painter, double value) const
{
    QwtText text = label(value);
    text.setRenderFlags(Qt::AlignHCenter | Qt::AlignTop);
    const QSizeF size = text.textSize(painter->font());
    text.draw(painter, {labelPosition(value) - QPointF(size.width() / 2.0, 0.0), size});
}

UnitScale::UnitScale()
{
    enableComponent(QwtAbstractScaleDraw::Backbone, false);
    enableComponent(QwtAbstractScaleDraw::Ticks, false);
}

QwtText UnitScale::label(double value) const
{
    const QList<double> ticks = scaleDiv().ticks(QwtScaleDiv::MajorTick);
    const QString number = QString::number(value);
    const bool isHighest = !ticks.isEmpty() && value >= ticks.last();
    return isHighest ? number + QLatin1Char(' ') + unit_ : number;
}

void UnitScale::setUnit(const QString& unit)
{
    unit_ = unit;
    invalidateCache();
}

void ForceChart::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                      const QRectF& /*canvas*/) const
{
    for (const Bar& bar : bars) {
        const QRectF rect = rectOf(bar.span, bar.value, xMap, yMap);
        fill(*painter, rect, bar);
        if (bar.saturated) mark(*painter, rect);
        if (!bar.peak) continue;
        const double y = yMap.transform(*bar.peak);
        painter->setPen(QPen(theme().text, 1.5));
        painter->drawLine(QPointF(rect.left(), y), QPointF(rect.right(), y));
    }
}

}  // namespace terratact
