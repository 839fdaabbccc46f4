#include "widgets/terrain/profile_layers.h"

#include <qwt_graphic.h>
#include <qwt_plot.h>
#include <qwt_scale_map.h>
#include <qwt_text.h>

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <functional>

#include "app/display/format.h"
#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/provenance_marks.h"

namespace terratact {
namespace {

constexpr double kAside = 0.018;  // [m] shift of the second estimate to the right

QString text(const char* words)
{
    return QCoreApplication::translate("terratact::TerrainProfileView", words);
}

QPointF pixel(const QwtScaleMap& x, const QwtScaleMap& y, double metres, double height)
{
    return {x.transform(metres), y.transform(height)};
}

/// Returns the line through the bins' heights; it has a gap where a height is not drawable.
QPainterPath profile(const Heights& heights, double aside, const QwtScaleMap& x,
                     const QwtScaleMap& y)
{
    QPainterPath path;
    bool pen = false;
    for (int bin = 0; bin < kBins; ++bin) {
        const double h = heights[static_cast<std::size_t>(bin)];
        const bool there = drawable(h);
        const QPointF point = there ? pixel(x, y, binCentre(bin) + aside, h) : QPointF();
        if (there && pen) path.lineTo(point);
        if (there && !pen) path.moveTo(point);
        pen = there;
    }
    return path;
}

QwtGraphic icon(const QPen& pen, const std::function<void(QPainter&)>& drawing)
{
    QwtGraphic graphic;
    graphic.setDefaultSize(QSizeF(26, 16));
    QPainter painter(&graphic);
    painter.setPen(pen);
    drawing(painter);
    return graphic;
}

QPen sampleLinePen()
{
    QColor colour = theme().sampled;
    colour.setAlpha(0x48);
    return {colour, 1.0};
}

QPen secondPen(Qt::PenStyle style)
{
    return {theme().muted, 1.5, style};
}

QPen twoPen()
{
    return {theme().warning, 2.0};
}

}  // namespace

SampleLines::SampleLines()
    : QwtPlotItem(QwtText(text(QT_TRANSLATE_NOOP("terratact::TerrainProfileView", "draws"))))
{
    setZ(18.0);
    setRenderHint(QwtPlotItem::RenderAntialiased);
    setItemAttribute(QwtPlotItem::Legend);
}

void SampleLines::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                       const QRectF& /*canvas*/) const
{
    painter->setPen(sampleLinePen());
    painter->setBrush(Qt::NoBrush);
    const std::size_t count = std::min(kMax, draws.size());
    for (std::size_t k = 0; k < count; ++k)
        painter->drawPath(profile(draws[k * draws.size() / count], 0.0, x, y));
}

QwtGraphic SampleLines::legendIcon(int /*index*/, const QSizeF& /*size*/) const
{
    return icon(sampleLinePen(), [](QPainter& painter) {
        for (const double at : {4.0, 8.0, 11.0})
            painter.drawLine(QPointF(0, at), QPointF(26, 15 - at));
    });
}

SecondEstimate::SecondEstimate() : QwtPlotItem(QwtText(QString()))
{
    setZ(23.0);
    setRenderHint(QwtPlotItem::RenderAntialiased);
    setItemAttribute(QwtPlotItem::Legend);
}

void SecondEstimate::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                          const QRectF& /*canvas*/) const
{
    if (!estimate) return;
    painter->setBrush(Qt::NoBrush);
    painter->setPen(secondPen(Qt::DotLine));
    painter->drawPath(profile(estimate->height, kAside, x, y));
    painter->setPen(secondPen(Qt::SolidLine));
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        const double at = binCentre(bin) + kAside;
        if (drawable(estimate->q10[i]) && drawable(estimate->q90[i]))
            painter->drawLine(pixel(x, y, at, estimate->q10[i]), pixel(x, y, at, estimate->q90[i]));
        if (!drawable(estimate->height[i])) continue;
        painter->setBrush(theme().card);
        painter->drawEllipse(pixel(x, y, at, estimate->height[i]), 3.5, 3.5);
        painter->setBrush(Qt::NoBrush);
    }
}

QwtGraphic SecondEstimate::legendIcon(int /*index*/, const QSizeF& /*size*/) const
{
    return icon(secondPen(Qt::SolidLine), [](QPainter& painter) {
        painter.drawLine(QPointF(13, 1), QPointF(13, 15));
        painter.setBrush(theme().card);
        painter.drawEllipse(QPointF(13, 8), 3.5, 3.5);
    });
}

StaleOverlay::StaleOverlay()
{
    setZ(35.0);
    setItemAttribute(QwtPlotItem::Legend, false);
}

void StaleOverlay::draw(QPainter* painter, const QwtScaleMap& /*x*/, const QwtScaleMap& /*y*/,
                        const QRectF& canvas) const
{
    if (words.isEmpty()) return;
    QColor veil = theme().card;
    veil.setAlpha(0x90);
    painter->fillRect(canvas, veil);
    QColor hatch = theme().muted;
    hatch.setAlpha(0x60);
    painter->save();
    painter->setClipRect(canvas, Qt::IntersectClip);
    painter->setPen(hatch);
    const double apart = scaled(20), height = canvas.height();
    const int lines = static_cast<int>((canvas.width() + height) / apart) + 1;
    for (int line = 0; line < lines; ++line) {
        const double foot = canvas.left() - height + line * apart;
        painter->drawLine(QPointF(foot, canvas.bottom()), QPointF(foot + height, canvas.top()));
    }
    painter->restore();

    QFont font = plot()->font();
    font.setPixelSize(scaled(15));
    font.setBold(true);
    painter->setFont(font);
    const QFontMetricsF metrics(font, painter->device());
    constexpr double kRoom = 8.0;  // [px]
    const double bottom = canvas.bottom() - MarkLetters::height(plot()->font());
    const QRectF place(canvas.left() + kRoom, bottom - metrics.height() - 2.0 * kRoom,
                       metrics.horizontalAdvance(words) + 2.0 * kRoom, metrics.height() + kRoom);
    painter->fillRect(place, theme().card);
    painter->setPen(theme().bad);
    painter->drawRect(place);
    painter->drawText(place, Qt::AlignCenter, words);
}

TwoHeights::TwoHeights()
    : QwtPlotItem(QwtText(text(QT_TRANSLATE_NOOP("terratact::TerrainProfileView", "either … or"))))
{
    setZ(27.0);
    setItemAttribute(QwtPlotItem::Legend, false);
}

void TwoHeights::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                      const QRectF& /*canvas*/) const
{
    QFont font = plot()->font();
    font.setPixelSize(std::max(10, font.pixelSize() - 3));
    font.setBold(true);
    painter->setFont(font);
    for (int bin = 0; bin < kBins; ++bin) {
        const auto& two = modes[static_cast<std::size_t>(bin)];
        if (!two) continue;
        const auto mark = [&](double height, double share) {
            if (!drawable(height)) return;
            const QPointF from = pixel(x, y, binBegin(bin) + 0.012, height);
            const QPointF to = pixel(x, y, binEnd(bin) - 0.012, height);
            painter->setPen(twoPen());
            painter->drawLine(from, to);
            const QRectF place(from.x(), from.y() + 2.0, to.x() - from.x(),
                               painter->fontMetrics().height());
            painter->drawText(place, Qt::AlignCenter,
                              format::percent(share) + QStringLiteral(" %"));
        };
        mark(two->highMean, two->highShare);
        mark(two->lowMean, two->lowShare);
    }
}

QwtGraphic TwoHeights::legendIcon(int /*index*/, const QSizeF& /*size*/) const
{
    return icon(twoPen(), [](QPainter& painter) {
        painter.drawLine(QPointF(4, 3), QPointF(22, 3));
        painter.drawLine(QPointF(4, 13), QPointF(22, 13));
    });
}

}  // namespace terratact
