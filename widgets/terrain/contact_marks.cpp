#include "widgets/terrain/contact_marks.h"

#include <qwt_plot.h>
#include <qwt_scale_map.h>

#include <QCoreApplication>
#include <QPainter>
#include <QStringList>
#include <algorithm>
#include <utility>

#include "widgets/base/drawable.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/terrain_items.h"

namespace terratact {
namespace {

constexpr int kContactRing = 7, kContactDot = 3, kWordSize = 13, kPad = 5,
              kAway = 12;  // [px at 100 %]

}  // namespace

ContactMarks::ContactMarks()
{
    setZ(60.0);  // above the robot and the profile
    setItemAttribute(QwtPlotItem::Legend, false);
}

bool ContactMarks::setPoints(std::vector<ContactPoint> points)
{
    std::erase_if(points, [](const ContactPoint& point) { return !drawable(point.at); });
    if (points == points_) return false;
    points_ = std::move(points);
    return true;
}

QString ContactMarks::words() const
{
    if (points_.empty()) return {};
    QStringList elements;
    for (const ContactPoint& point : points_)
        if (!point.element.isEmpty()) elements << point.element;
    return QCoreApplication::translate("terratact::ContactMarks", "CONTACT %1")
        .arg(elements.join(QLatin1Char(' ')));
}

void ContactMarks::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                        const QRectF& canvas) const
{
    if (points_.empty()) return;
    painter->setRenderHint(QPainter::Antialiasing);
    QPointF foremost(canvas.left(), canvas.bottom());
    for (const ContactPoint& point : points_) {
        const QPointF at(x.transform(point.at.x()), y.transform(point.at.y()));
        if (at.x() >= foremost.x()) foremost = at;
        painter->setPen(QPen(theme().felt.text, scaled(2)));
        painter->setBrush(theme().felt.area);
        painter->drawEllipse(at, scaled(kContactRing), scaled(kContactRing));
        painter->setPen(Qt::NoPen);
        painter->setBrush(theme().felt.text);
        painter->drawEllipse(at, scaled(kContactDot), scaled(kContactDot));
    }
    painter->setFont(sized(plot()->font(), kWordSize, true));
    const QString text = words();
    const QSizeF size(painter->fontMetrics().horizontalAdvance(text) + 2.0 * scaled(kPad),
                      painter->fontMetrics().height() + 2.0);
    QRectF pill(foremost + QPointF(scaled(kAway), -size.height() / 2.0), size);
    // Before the robot if there is room, else below the contact.
    if (pill.right() > canvas.right())
        pill.moveTopRight({std::min(foremost.x() + scaled(kContactRing), canvas.right()),
                           foremost.y() + scaled(kAway)});
    if (pill.bottom() > canvas.bottom()) pill.moveBottom(canvas.bottom());
    painter->setPen(Qt::NoPen);
    painter->setBrush(theme().felt.area);
    painter->drawRoundedRect(pill, 4.0, 4.0);
    painter->setPen(theme().felt.text);
    painter->drawText(pill, Qt::AlignCenter, text);
}

}  // namespace terratact
