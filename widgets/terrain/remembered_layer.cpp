#include "widgets/terrain/remembered_layer.h"

#include <qwt_graphic.h>
#include <qwt_plot.h>
#include <qwt_scale_map.h>
#include <qwt_text.h>

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <iterator>
#include <span>

#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"

namespace terratact {
namespace {

QPen rememberedPen(FeltBy felt, double width)
{
    QPen pen(theme().sampled, width, Qt::CustomDashLine, Qt::FlatCap);
    const bool wasFelt = isFelt(felt) || felt == FeltBy::Unrecorded;
    pen.setDashPattern(wasFelt ? QList<qreal>{4.0, 3.0} : QList<qreal>{1.0, 1.5});
    return pen;
}

QColor rememberedBand()
{
    QColor colour = theme().sampled;
    colour.setAlpha(0x2c);
    return colour;
}

bool isDrawn(const SeenBin& bin, bool isBesideEstimate)
{
    if (isBesideEstimate && bin.x > binBegin(0) - kBinWidth / 2.0) return false;
    return bin.felt != FeltBy::NotFelt && bin.band.sd <= RememberedLayer::kMaxSd
        && drawable(bin.band.height) && drawable(bin.band.q10) && drawable(bin.band.q90);
}

/// Returns runs of neighbouring bins.
std::vector<std::span<const SeenBin>> runsOf(const std::vector<SeenBin>& bins)
{
    std::vector<std::span<const SeenBin>> runs;
    runs.reserve(bins.size());
    for (std::size_t first = 0; first < bins.size();) {
        std::size_t end = first + 1;
        while (end < bins.size() && bins[end].x - bins[end - 1].x < RememberedLayer::kNeighbour)
            ++end;
        runs.push_back(std::span(bins).subspan(first, end - first));
        first = end;
    }
    return runs;
}

/// Draws remembered ground on one canvas.
class RememberedPainter {
public:
    RememberedPainter(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y)
        : painter_(painter), x_(x), y_(y)
    {
    }

    void drawRun(std::span<const SeenBin> run) const
    {
        QPolygonF low, band;
        for (const SeenBin& bin : run) {
            low << at(bin.x, bin.band.q10);
            band << at(bin.x, bin.band.q90);
        }
        painter_.setBrush(Qt::NoBrush);
        painter_.setPen(rememberedPen(FeltBy::Track, 1.0));
        painter_.drawPolyline(low);
        painter_.drawPolyline(band);
        if (run.size() == 1) painter_.drawLine(low.front(), band.front());
        std::for_each(low.rbegin(), low.rend(), [&](const QPointF& point) { band << point; });
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(rememberedBand());
        painter_.drawPolygon(band);
        painter_.setBrush(Qt::NoBrush);
        drawLine(run);
    }

    void drawLetter(const SeenBin& bin, const QString& letter) const
    {
        constexpr double kGap = 6.0;  // [px] between the letter and the line
        painter_.setPen(theme().sampled);
        const double width = painter_.fontMetrics().horizontalAdvance(letter);
        painter_.drawText(at(bin.x, bin.band.height) - QPointF(width + kGap, 0), letter);
    }

private:
    /// Draws neighbouring stretches that were felt alike in one stroke, so that their dashes continue.
    void drawLine(std::span<const SeenBin> run) const
    {
        for (std::size_t first = 0; first + 1 < run.size();) {
            const QPen pen = penBetween(run[first], run[first + 1]);
            QPolygonF line{at(run[first].x, run[first].band.height)};
            std::size_t last = first;
            while (last + 1 < run.size() && penBetween(run[last], run[last + 1]) == pen) {
                ++last;
                line << at(run[last].x, run[last].band.height);
            }
            painter_.setPen(pen);
            painter_.drawPolyline(line);
            first = last;
        }
    }

    static QPen penBetween(const SeenBin& a, const SeenBin& b)
    {
        return rememberedPen(across(a.felt, b.felt), 2.5);
    }

    QPointF at(double metres, double height) const
    {
        return {x_.transform(metres), y_.transform(height)};
    }

    QPainter& painter_;
    const QwtScaleMap& x_;
    const QwtScaleMap& y_;
};

}  // namespace

RememberedLayer::RememberedLayer()
    : QwtPlotItem(
        QwtText(QCoreApplication::translate("terratact::TerrainProfileView", "remembered")))
{
    setZ(17.0);
    setRenderHint(QwtPlotItem::RenderAntialiased);
    setItemAttribute(QwtPlotItem::Legend);
}

void RememberedLayer::setStrip(const SeenStrip& strip, bool isBesideEstimate)
{
    strip_ = strip;
    isBesideEstimate_ = isBesideEstimate;
    for (std::size_t side = 0; side < 2; ++side) {
        std::vector<SeenBin>& drawn = drawn_.at(side);
        drawn.clear();
        if (side == 1 && strip.onePlane) continue;
        std::ranges::copy_if(strip.side.at(side), std::back_inserter(drawn),
                             [&](const SeenBin& bin) { return isDrawn(bin, isBesideEstimate); });
    }
}

void RememberedLayer::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                           const QRectF& /*canvas*/) const
{
    const RememberedPainter remembered(*painter, x, y);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::vector<SeenBin>& bins = drawn_.at(side);
        for (const auto run : runsOf(bins)) remembered.drawRun(run);
        if (!strip_.onePlane && !bins.empty())
            remembered.drawLetter(bins.front(),
                                  side == 0 ? QStringLiteral("L") : QStringLiteral("R"));
    }
}

QwtGraphic RememberedLayer::legendIcon(int /*index*/, const QSizeF& /*size*/) const
{
    QwtGraphic graphic;
    graphic.setDefaultSize(QSizeF(26, 16));
    QPainter painter(&graphic);
    painter.fillRect(QRectF(0, 2, 26, 12), rememberedBand());
    painter.setPen(rememberedPen(FeltBy::Track, 2.5));
    painter.drawLine(QPointF(0, 8), QPointF(26, 8));
    return graphic;
}

}  // namespace terratact
