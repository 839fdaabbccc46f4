#include "widgets/signals/plot_curves.h"

#include <qwt_scale_map.h>

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/display/format.h"
#include "widgets/base/palette.h"

namespace terratact {
namespace {

constexpr double kFarOutside = 20'000.0;  // [px] Qt's raster engine draws no further

double clampedPixel(const QwtScaleMap& map, double value)
{
    return std::clamp(map.transform(value), -kFarOutside, kFarOutside);
}

QFont legendFont(const QPainter& painter)
{
    QFont font = painter.font();
    font.setPixelSize(scaled(13));
    return font;
}

}  // namespace

std::vector<QPolygonF> curveLines(const TimePlotCurve& curve, const QwtScaleMap& x,
                                  const QwtScaleMap& y, double until)
{
    const SeriesView& view = curve.view;
    std::vector<QPolygonF> lines;
    double before = 0.0;
    if (curve.isHeld && view.before)
        lines.push_back({{clampedPixel(x, x.s1()), clampedPixel(y, *view.before)}});
    for (const SeriesColumn& column : view.columns) {
        const SeriesSummary& sum = column.summary;
        const double at = clampedPixel(x, column.time);
        const bool isNew =
            lines.empty() || (!curve.isHeld && column.time - before > view.breakAfter);
        before = column.time;
        if (isNew) lines.emplace_back();
        QPolygonF& line = lines.back();
        if (curve.isHeld && !line.isEmpty()) line << QPointF(at, line.last().y());
        if (sum.count > 1) {
            // Begins with the end that is nearer to the line so far.
            double first = clampedPixel(y, sum.low), second = clampedPixel(y, sum.high);
            if (!line.isEmpty()
                && std::abs(line.last().y() - second) < std::abs(line.last().y() - first))
                std::swap(first, second);
            line << QPointF(at, first) << QPointF(at, second);
        }
        line << QPointF(at, clampedPixel(y, sum.last));
    }
    if (curve.isHeld && !lines.empty())
        lines.back() << QPointF(clampedPixel(x, std::min(until, x.s2())), lines.back().last().y());
    return lines;
}

std::optional<std::pair<double, double>> visibleRange(const std::vector<TimePlotCurve>& curves)
{
    std::optional<std::pair<double, double>> range;
    const auto add = [&range](double low, double high) {
        range = range ? std::pair(std::min(range->first, low), std::max(range->second, high))
                      : std::pair(low, high);
    };
    for (const TimePlotCurve& curve : curves) {
        for (const SeriesColumn& column : curve.view.columns)
            add(column.summary.low, column.summary.high);
        if (curve.isHeld && curve.view.before) add(*curve.view.before, *curve.view.before);
    }
    return range;
}

QColor PlotCurves::colourOf(std::size_t curve)
{
    const std::array colours{theme().contact, theme().prior, theme().sampled, theme().arm};
    return colours.at(curve % colours.size());
}

QString PlotCurves::legendOf(std::size_t curve, const TimePlotCurve& its)
{
    const QString value =
        its.view.atCursor ? format::significant(*its.view.atCursor, 5) : format::kNothing;
    return QStringLiteral("%1 %2  %3 %4")
        .arg(QString::number(curve + 1), its.name, value, its.unit)
        .trimmed();
}

void PlotCurves::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                      const QRectF& canvas) const
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing,
                           false);  // wide antialiased lines take milliseconds
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto lines = curveLines(curves[i], x, y, until);
        QPen pen(colourOf(i), 0.0);
        pen.setCosmetic(true);
        painter->setPen(pen);
        for (const QPolygonF& line : lines) {
            if (line.size() == 1)
                painter->fillRect(QRectF(line.first() - QPointF(1.0, 1.0), QSizeF(3.0, 3.0)),
                                  colourOf(i));
            else
                painter->drawPolyline(line);
        }
        if (!lines.empty()) drawNumber(*painter, i, lines.back().last(), canvas);
    }
    if (cursor) {
        const double at = clampedPixel(x, *cursor);
        painter->setPen(QPen(theme().text, 0.0, Qt::DashLine));
        painter->drawLine(QPointF(at, canvas.top()), QPointF(at, canvas.bottom()));
    }
    drawLegend(*painter, canvas);
    if (box) {
        QColor fill = theme().contact;
        fill.setAlpha(50);
        painter->fillRect(*box, fill);
        painter->setPen(theme().contact);
        painter->drawRect(*box);
    }
    if (isChosen) {
        painter->setPen(QPen(theme().primary.area, 2.0));
        painter->drawRect(canvas.adjusted(1.0, 1.0, -1.0, -1.0));
    }
    painter->restore();
}

/// Draws the curve's number at its newest point, so that no curve is known by its colour alone.
void PlotCurves::drawNumber(QPainter& painter, std::size_t curve, QPointF end,
                            const QRectF& canvas) const
{
    if (curves.size() < 2) return;
    painter.setFont(legendFont(painter));
    const double size = QFontMetricsF(painter.font()).height();
    const double left = std::clamp(end.x(), canvas.left(), canvas.right() - size);
    const double top = std::clamp(end.y() - size / 2.0, canvas.top(), canvas.bottom() - size);
    const QRectF place(left, top, 0.8 * size, size);
    painter.fillRect(place, theme().card);
    painter.setPen(colourOf(curve));
    painter.drawText(place, Qt::AlignCenter, QString::number(curve + 1));
}

void PlotCurves::drawLegend(QPainter& painter, const QRectF& canvas) const
{
    painter.setFont(legendFont(painter));
    const QFontMetricsF metrics(painter.font());
    const double gap = metrics.horizontalAdvance(QLatin1Char('M'));
    QColor ground = theme().card;
    ground.setAlpha(215);
    double left = canvas.left() + 0.5 * gap, top = canvas.top() + 2.0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const QString whole = legendOf(i, curves[i]);
        double width = metrics.horizontalAdvance(whole);
        if (left + width > canvas.right() && left > canvas.left() + gap) {  // in the next line
            left = canvas.left() + 0.5 * gap;
            top += metrics.height();
        }
        width = std::min(width, canvas.right() - left - gap);
        if (width <= 0.0 || top + metrics.height() > canvas.bottom()) return;
        const QRectF place(left, top, width + 2.0, metrics.height());
        painter.fillRect(place, ground);
        painter.setPen(colourOf(i));
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(whole, Qt::ElideMiddle, width + 2.0));
        left += width + 1.5 * gap;
    }
}

}  // namespace terratact
