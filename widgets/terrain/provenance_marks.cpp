#include "widgets/terrain/provenance_marks.h"

#include <qwt_graphic.h>
#include <qwt_plot.h>
#include <qwt_scale_map.h>

#include <QPainter>
#include <algorithm>
#include <utility>

#include "widgets/base/palette.h"
#include "widgets/terrain/provenance_text.h"

namespace terratact {
namespace {

constexpr double kThin = 2.0;      // [px]
constexpr double kFarthest = 1e4;  // [px] outside every screen

constexpr int kLargestLetter = 13;  // [px] at 100 %

QFont letterFont(QFont font, int pixels)
{
    font.setPixelSize(pixels);
    font.setBold(true);
    return font;
}

QPen barPen(Provenance provenance, const QColor& colour)
{
    const BarPattern pattern = barPattern(provenance);
    QPen pen(colour, pattern.width, Qt::SolidLine, Qt::FlatCap);
    if (!pattern.dashes.empty()) pen.setDashPattern({pattern.dashes.begin(), pattern.dashes.end()});
    return pen;
}

}  // namespace

ProvenanceMark markOf(Provenance provenance)
{
    const Theme& t = theme();
    const auto mark = [provenance](QwtSymbol::Style shape, const QColor& line, int size) {
        return ProvenanceMark{shape, line, size, barPen(provenance, line)};
    };
    switch (provenance) {
    case Provenance::Arm: return mark(QwtSymbol::Triangle, t.arm, 13);
    case Provenance::Contact: return mark(QwtSymbol::Rect, t.contact, 11);
    case Provenance::Constrained: return mark(QwtSymbol::DTriangle, t.sampled, 11);
    case Provenance::Sampled: return mark(QwtSymbol::Ellipse, t.sampled, 10);
    case Provenance::PriorOnly: break;
    }
    return mark(QwtSymbol::Diamond, t.prior, 14);
}

QBrush brushOf(MarkFill fill, const QColor& colour)
{
    if (fill != MarkFill::LowerHalf) return fill == MarkFill::Full ? colour : theme().card;
    constexpr double kHalf = 0.5, kEdge = 1e-3;
    QLinearGradient halves(0.0, 0.0, 0.0, 1.0);
    halves.setCoordinateMode(QGradient::ObjectMode);
    halves.setColorAt(kHalf, theme().card);
    halves.setColorAt(kHalf + kEdge, colour);
    return halves;
}

PatternBar::PatternBar(const QPen& pen) : QwtIntervalSymbol(QwtIntervalSymbol::Bar)
{
    setPen(pen);
    setWidth(scaled(13));
}

void PatternBar::draw(QPainter* painter, Qt::Orientation /*orientation*/, const QPointF& from,
                      const QPointF& to) const
{
    const auto near = [](QPointF point) {
        point.setY(std::clamp(point.y(), -kFarthest, kFarthest));
        return point;
    };
    const QPointF ends[]{near(from), near(to)};
    painter->setPen(pen());
    painter->drawLine(ends[0], ends[1]);
    painter->setPen(QPen(pen().color(), kThin));
    const QPointF half(width() / 2.0, 0.0);
    for (const QPointF& end : ends) painter->drawLine(end - half, end + half);
}

MarkCurve::MarkCurve(Provenance provenance)
    : QwtPlotCurve(provenanceLetter(provenance) + QStringLiteral(": ")
                   + provenanceWord(provenance)),
      provenance_(provenance)
{
    setStyle(QwtPlotCurve::NoCurve);
    setRenderHint(QwtPlotItem::RenderAntialiased);
}

void MarkCurve::setMarks(const QVector<QPointF>& points, std::vector<MarkFill> fills)
{
    fills_ = std::move(fills);
    setSamples(points);
}

void MarkCurve::drawSymbols(QPainter* painter, const QwtSymbol& symbol, const QwtScaleMap& x,
                            const QwtScaleMap& y, const QRectF& canvas, int from, int to) const
{
    for (int i = from; i <= to; ++i) {
        const QwtSymbol mark(symbol.style(),
                             brushOf(fills_[static_cast<std::size_t>(i)], symbol.pen().color()),
                             symbol.pen(), symbol.size());
        QwtPlotCurve::drawSymbols(painter, mark, x, y, canvas, i, i);
    }
}

QwtGraphic MarkCurve::legendIcon(int /*index*/, const QSizeF& /*size*/) const
{
    if (!symbol()) return {};  // not styled yet
    const QSizeF size(scaled(26), scaled(16));
    QwtGraphic icon;
    icon.setDefaultSize(size);
    QPainter painter(&icon);
    const double middle = size.height() / 2.0;
    painter.setPen(markOf(provenance_).bar);
    painter.drawLine(QPointF(0.0, middle), QPointF(size.width(), middle));
    painter.setRenderHint(QPainter::Antialiasing);
    symbol()->drawSymbol(&painter, QPointF(size.width() / 2.0, middle));
    return icon;
}

MarkLetters::MarkLetters()
{
    setZ(30.0);
    setItemAttribute(QwtPlotItem::Legend, false);
}

double MarkLetters::height(const QFont& ofPlot)
{
    return QFontMetricsF(letterFont(ofPlot, scaled(kLargestLetter))).height();
}

double MarkLetters::reserved(const QFont& ofPlot, double canvasHeight, int rows)
{
    constexpr double kMax = 1.0 / 16.0;  // share of the canvas height, per row
    const double strip = height(ofPlot);
    return strip <= kMax * canvasHeight ? rows * strip : 0.0;
}

void MarkLetters::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& /*y*/,
                       const QRectF& canvas) const
{
    constexpr int kMin = 10;  // [px]
    const double width = x.transform(binEnd(0)) - x.transform(binBegin(0));
    const int largest = scaled(kLargestLetter);
    painter->setFont(letterFont(
        plot()->font(), std::clamp(static_cast<int>(width), std::min(kMin, largest), largest)));
    const double height = MarkLetters::height(plot()->font());
    const double lowest = canvas.bottom() - height;
    if (!light || reserved(plot()->font(), canvas.height()) <= 0.0)
        return drawRow(*painter, x, lowest, shown, letter);
    drawRow(*painter, x, isLightAbove ? lowest - height : lowest, *light, lightLetter);
    drawRow(*painter, x, isLightAbove ? lowest : lowest - height, shown, letter);
}

void MarkLetters::drawRow(QPainter& painter, const QwtScaleMap& x, double top, const Row& row,
                          const QString& of) const
{
    const double width = x.transform(binEnd(0)) - x.transform(binBegin(0));
    const double height = MarkLetters::height(plot()->font());
    QColor behind = theme().card;
    behind.setAlpha(0xd0);
    painter.setPen(theme().text);
    const auto draw = [&](double left, const QString& text) {
        const QRectF place(left, top, width, height);
        painter.fillRect(place, behind);
        painter.drawText(place, Qt::AlignCenter, text);
    };
    for (std::size_t i = 0; i < kBins; ++i)
        if (row[i]) draw(x.transform(binBegin(static_cast<int>(i))), provenanceLetter(*row[i]));
    if (!of.isEmpty()) draw(x.transform(binBegin(0)) - width, of + QLatin1Char(':'));
}

}  // namespace terratact
