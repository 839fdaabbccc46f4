#include "app/imports/truth_view.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/display/format.h"
#include "app/display/units.h"
#include "widgets/base/palette.h"

namespace terratact {
namespace {

constexpr QSize kTruthViewMin{420, 240};  // [px] at 100 %
constexpr double kGridStep = 0.2;         // [m]
constexpr double kSideShift = 2.5;        // [px] between the whiskers of both sides
constexpr double kBinGap = 0.008;         // [m] left free at both ends of a bin

QColor sideColour(Side side)
{
    return side == Side::Left ? theme().contact : theme().prior;
}

/// Draws in metres of the DEM frame, with equal scales.
class TruthPainter {
public:
    TruthPainter(QPainter& painter, const QRectF& area) : painter_(painter)
    {
        const double width = kSliceFront - kSliceRear, height = kSliceTop - kSliceBottom;
        scale_ = std::min(area.width() / width, area.height() / height);
        const QSizeF size(scale_ * width, scale_ * height);
        area_ = QRectF(area.center() - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
    }

    QPointF at(double x, double z) const
    {
        return {area_.left() + (x - kSliceRear) * scale_, area_.top() + (kSliceTop - z) * scale_};
    }
    const QRectF& area() const { return area_; }

    void drawGrid()
    {
        const QFontMetrics letters(painter_.font());
        const auto text = [&](double metres) {
            return units().length == LengthUnit::Centimetre
                     ? format::signedNumber(100.0 * metres, 0)
                     : format::signedNumber(metres, 1);
        };
        painter_.fillRect(area_, theme().card);
        for (int k = -4; k <= 4; ++k) {
            const double x = kGridStep * k;
            const QString label = text(x);
            drawLine(at(x, kSliceTop), at(x, kSliceBottom), label,
                     {-0.5 * letters.horizontalAdvance(label), letters.ascent() + 2.0});
        }
        for (int k = -4; k <= 2; ++k) {
            const double z = kGridStep * k;
            const QString label = text(z);
            drawLine(at(kSliceFront, z), at(kSliceRear, z), label,
                     {-letters.horizontalAdvance(label) - 4.0, 0.35 * letters.ascent()});
        }
        drawNames();
    }

    void drawRobot(const Outline& outline)
    {
        painter_.setPen(QPen(theme().robotLine, 1.0));
        QColor fill = theme().robotBody;
        fill.setAlphaF(0.7F);
        painter_.setBrush(fill);
        for (const OutlinePart& part : outline) {
            QPolygonF corners;
            for (const auto& [x, z] : part.points) corners << at(x, z);
            painter_.drawPolygon(corners);
        }
    }

    void drawPoints(const std::vector<SlicePoint>& slice, Side side)
    {
        const double r = std::max(1.0, 0.5 * scaled(3));
        QColor colour = sideColour(side);
        colour.setAlphaF(0.55F);
        painter_.setPen(QPen(colour, 1.0));
        for (const SlicePoint& point : slice) {
            if (sideOf(point.line) != side) continue;
            const QPointF p = at(point.x, point.z);
            if (side == Side::Left) {
                painter_.fillRect(QRectF(p.x() - r, p.y() - r, 2.0 * r, 2.0 * r), colour);
            } else {
                painter_.drawLine(p + QPointF(-r, -r), p + QPointF(r, r));
                painter_.drawLine(p + QPointF(-r, r), p + QPointF(r, -r));
            }
        }
    }

    void drawBins(const SideTruth& bins, const QColor& colour, Qt::PenStyle style, double shift)
    {
        for (int i = 0; i < kBins; ++i) {
            const BinTruth& bin = bins.at(static_cast<std::size_t>(i));
            if (!bin.height) continue;
            painter_.setPen(QPen(colour, scaled(3), style, Qt::FlatCap));
            painter_.drawLine(at(binBegin(i) + kBinGap, *bin.height),
                              at(binEnd(i) - kBinGap, *bin.height));
            const QPointF aside(shift, 0.0);
            const auto whisker = [&](double sds, double width) {
                painter_.setPen(QPen(colour, width));
                painter_.drawLine(at(binCentre(i), *bin.height - sds * bin.sd) + aside,
                                  at(binCentre(i), *bin.height + sds * bin.sd) + aside);
            };
            whisker(2.0, scaled(1));
            whisker(1.0, scaled(3));
        }
    }

    void crossOut()
    {
        painter_.setPen(QPen(theme().bad, scaled(3)));
        painter_.drawLine(area_.topLeft(), area_.bottomRight());
        painter_.drawLine(area_.topRight(), area_.bottomLeft());
    }

private:
    void drawNames()
    {
        const QRectF inside = area_.adjusted(4.0, 2.0, -4.0, -2.0);
        painter_.setPen(theme().muted);
        painter_.drawText(inside, Qt::AlignLeft | Qt::AlignTop,
                          TruthView::tr("height [%1]").arg(format::lengthUnit()));
        painter_.drawText(inside, Qt::AlignRight | Qt::AlignBottom,
                          TruthView::tr("forward from the IMU [%1]").arg(format::lengthUnit()));
    }

    /// Draws a line of the grid, and its label beside its end.
    void drawLine(const QPointF& from, const QPointF& to, const QString& label,
                  const QPointF& beside)
    {
        painter_.setPen(QPen(theme().grid, 1.0));
        painter_.drawLine(from, to);
        painter_.setPen(theme().muted);
        painter_.drawText(to + beside, label);
    }

    QPainter& painter_;
    QRectF area_;
    double scale_ = 1.0;  ///< [px/m]
};

}  // namespace

TruthView::TruthView(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Slice of the cloud, robot and bins"));
}

void TruthView::setScene(Scene scene)
{
    scene_ = std::move(scene);
    update();
}

void TruthView::setSides(Sides sides)
{
    sides_ = sides;
    update();
}

bool TruthView::shows(Side side) const
{
    return sides_ == Sides::Both || (sides_ == Sides::Left) == (side == Side::Left);
}

QSize TruthView::minimumSizeHint() const
{
    return kTruthViewMin;
}

QSize TruthView::sizeHint() const
{
    return 2 * kTruthViewMin;
}

void TruthView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetrics letters(font());
    const double beside = letters.horizontalAdvance(format::signedNumber(-0.8, 1)) + 8.0;
    TruthPainter picture(painter, QRectF(rect()).adjusted(beside, 0.5 * letters.height(), -beside,
                                                          -letters.height() - 4.0));
    picture.drawGrid();
    painter.save();
    painter.setClipRect(picture.area());
    picture.drawRobot(scene_.outline);
    for (const Side side : {Side::Right, Side::Left})
        if (shows(side)) picture.drawPoints(scene_.slice, side);
    if (scene_.isPlane) {
        picture.drawBins(scene_.side[0], theme().sampled, Qt::SolidLine, 0.0);
    } else {
        if (shows(Side::Right))
            picture.drawBins(scene_.side[1], sideColour(Side::Right), Qt::DashLine, kSideShift);
        if (shows(Side::Left))
            picture.drawBins(scene_.side[0], sideColour(Side::Left), Qt::SolidLine, -kSideShift);
    }
    if (scene_.isExcluded) picture.crossOut();
    painter.restore();
    if (scene_.gap.isEmpty()) return;
    painter.setPen(theme().bad);
    painter.drawText(picture.area().adjusted(8.0, 6.0, -8.0, 0.0),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, scene_.gap);
}

}  // namespace terratact
