#include "widgets/terrain/measured_line.h"

#include <qwt_plot.h>
#include <qwt_scale_map.h>

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/display/format.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/terrain_items.h"

namespace terratact {
namespace {

struct MeasuredWords {
    Q_DECLARE_TR_FUNCTIONS(MeasuredLine)
};

constexpr int kEndRadius = 6, kFramePad = 8, kFrameGap = 4, kFrameText = 13;  // [px at 100 %]

QString endText(const QString& name, const MeasuredEnd& end)
{
    const QString height = format::signedLength(end.at.y(), 3);
    switch (end.kind) {
    case MeasuredEnd::Kind::Unfelt: return QStringLiteral("%1: %2").arg(name, end.word);
    case MeasuredEnd::Kind::Free: return QStringLiteral("%1: %2 (%3)").arg(name, height, end.word);
    case MeasuredEnd::Kind::Felt:
    case MeasuredEnd::Kind::Remembered: break;
    }
    return QStringLiteral("%1: %2 ± %3 (%4)")
        .arg(name, height, format::length(end.sd, 3), end.word);
}

}  // namespace

MeasuredSlope measuredSlope(const MeasuredEnd& a, const MeasuredEnd& b)
{
    const bool isForward = a.at.x() <= b.at.x();
    const QPointF way = isForward ? b.at - a.at : a.at - b.at;
    MeasuredSlope slope{.distance = way.x(), .rise = {}, .slope = {}};
    if (!a.isKnown() || !b.isKnown()) return slope;
    slope.rise = way.y();
    if (!way.isNull()) slope.slope = std::atan2(way.y(), way.x());
    return slope;
}

QStringList measuredText(const MeasuredEnd& a, const MeasuredEnd& b)
{
    const MeasuredSlope measured = measuredSlope(a, b);
    const QString distance = format::length(measured.distance, 2);
    const bool isForward = a.at.x() <= b.at.x();
    QString first;
    if (!measured.rise)
        first = MeasuredWords::tr("%1 apart · rise and slope unknown: not felt").arg(distance);
    else
        first = MeasuredWords::tr("%1 apart · rise %2 · slope %3")
                    .arg(distance, format::signedLength(*measured.rise, 3),
                         measured.slope ? format::angle(*measured.slope) : format::kNothing);
    return {first, endText(MeasuredWords::tr("rear"), isForward ? a : b) + QStringLiteral(" · ")
                       + endText(MeasuredWords::tr("front"), isForward ? b : a)};
}

MeasuredLine::MeasuredLine()
{
    setZ(70.0);  // above everything else
    setItemAttribute(QwtPlotItem::Legend, false);
}

void MeasuredLine::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                        const QRectF& canvas) const
{
    painter->setRenderHint(QPainter::Antialiasing);
    if (ends) {
        const auto pixel = [&](const QPointF& at) {
            return QPointF(x.transform(at.x()), y.transform(at.y()));
        };
        const QPointF a = pixel((*ends)[0].at), b = pixel((*ends)[1].at);
        const bool isKnown = (*ends)[0].isKnown() && (*ends)[1].isKnown();
        // A wide line of the card's colour keeps it visible on every layer.
        painter->setPen(QPen(theme().card, scaled(6)));
        painter->drawLine(a, b);
        painter->setPen(QPen(theme().text, scaled(2), isKnown ? Qt::SolidLine : Qt::DotLine));
        painter->drawLine(a, b);
        painter->setPen(QPen(theme().text, 1.0, Qt::DashLine));
        const QPointF corner = a.x() <= b.x() ? QPointF(b.x(), a.y()) : QPointF(a.x(), b.y());
        painter->drawLine(a, corner);
        painter->drawLine(corner, b);
        for (const auto& [at, end] : {std::pair(a, (*ends)[0]), std::pair(b, (*ends)[1])}) {
            painter->setPen(QPen(theme().text, scaled(2)));
            painter->setBrush(end.isKnown() ? QBrush(theme().text) : QBrush(theme().card));
            const double half = scaled(kEndRadius);
            painter->drawRect(QRectF(at.x() - half / 2, at.y() - half / 2, half, half));
            painter->setBrush(Qt::NoBrush);
            painter->drawEllipse(at, 1.5 * half, 1.5 * half);
        }
    }
    drawFrame(*painter, x, y, canvas);
}

void MeasuredLine::drawFrame(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
                             const QRectF& canvas) const
{
    if (lines.isEmpty()) return;
    painter.setFont(sized(plot()->font(), kFrameText));
    const int width = static_cast<int>(canvas.width()) - 2 * scaled(kFrameGap + kFramePad);
    const QString text = lines.join(QLatin1Char('\n'));
    const QRectF words = painter.boundingRect(QRectF(0, 0, width, canvas.height()),
                                              Qt::AlignLeft | Qt::TextWordWrap, text);
    const double pad = scaled(kFramePad);
    QRectF frame = words.adjusted(-pad, -pad / 2, pad, pad / 2);
    const double gap = scaled(kFrameGap);
    frame.moveTopRight(canvas.topRight() + QPointF(-gap, gap));
    const auto covers = [&](const MeasuredEnd& end) {
        return frame.contains(QPointF(x.transform(end.at.x()), y.transform(end.at.y())));
    };
    if (ends && std::ranges::any_of(*ends, covers))
        frame.moveBottomRight(canvas.bottomRight() - QPointF(gap, gap));
    painter.setPen(QPen(theme().text, 1.5));
    painter.setBrush(theme().card);
    painter.drawRoundedRect(frame, 4, 4);
    painter.drawText(frame.adjusted(pad, pad / 2, -pad, -pad / 2), Qt::AlignLeft | Qt::TextWordWrap,
                     text);
}

}  // namespace terratact
