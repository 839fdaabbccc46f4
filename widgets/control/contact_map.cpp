#include "widgets/control/contact_map.h"

#include <QPainter>
#include <algorithm>

#include "app/display/place_text.h"

namespace terratact {
namespace {

constexpr int kLetterSize = 13, kNumberSize = 11;  // [px at 100 %]
constexpr double kFullBar = 20.0;                  // [N] fills the box

/// Sizes [px at 100 %]; a small map has no letters in front of its rows.
struct Sizes {
    int box, row, letter, gap;
};
constexpr Sizes kWhole{14, 17, 13, 6}, kSmall{9, 9, 0, 4};

Sizes sizesOf(bool isSmall)
{
    const Sizes& at100 = isSmall ? kSmall : kWhole;
    return {scaledLarge(at100.box), scaledLarge(at100.row), scaledLarge(at100.letter),
            scaledLarge(at100.gap)};
}

bool hasRear(const std::optional<FlipperContacts>& contacts)
{
    return contacts && (contacts->knows(Flipper::RearLeft) || contacts->knows(Flipper::RearRight));
}

/// A number of 0 draws the box without it.
void drawElement(QPainter& painter, const QRectF& box, int number,
                 const FlipperContacts::Element& element, const Fill& fill)
{
    const QColor& ink = fill.text;
    painter.setPen(QPen(ink, 1.0, element.force ? Qt::SolidLine : Qt::DotLine));
    painter.setBrush(element.touches ? QBrush(ink) : QBrush(Qt::NoBrush));
    painter.drawRect(box);
    if (!element.force) {
        painter.drawLine(box.topLeft(), box.bottomRight());
        return;
    }
    if (!element.touches) {
        const double share = std::clamp(*element.force / kFullBar, 0.0, 1.0);
        QRectF bar = box;
        bar.setTop(box.bottom() - share * box.height());
        painter.fillRect(bar, ink);
    }
    if (number == 0) return;
    painter.setPen(element.touches ? fill.area : ink);
    QFont digits = painter.font();
    digits.setPixelSize(scaledLarge(kNumberSize));
    digits.setBold(element.touches);
    painter.setFont(digits);
    painter.drawText(box, Qt::AlignCenter, QString::number(number));
}

void drawLetter(QPainter& painter, const QRectF& area, Side side, const Fill& fill)
{
    QFont letters = painter.font();
    letters.setPixelSize(scaledLarge(kLetterSize));
    letters.setBold(false);
    painter.setFont(letters);
    painter.setPen(fill.text);
    painter.drawText(area, Qt::AlignCenter, sideLetter(side));
}

}  // namespace

QSize ContactMap::size() const
{
    const Sizes sizes = sizesOf(isSmall);
    const int front = sizes.letter + kForceElements * sizes.box;
    const int rear = hasRear(contacts) ? sizes.gap + kForceElements * sizes.box : 0;
    return {front + rear + 1, 2 * sizes.row + 1};
}

void ContactMap::draw(QPainter& painter, const QRectF& area, const Fill& fill) const
{
    const Sizes sizes = sizesOf(isSmall);
    const QSize all = size();
    const double left = area.right() - all.width(), top = area.center().y() - all.height() / 2.0;
    const bool rear = hasRear(contacts);
    const double front = left + (rear ? kForceElements * sizes.box + sizes.gap : 0.0);
    for (const Side side : {Side::Left, Side::Right}) {
        const double y = top + (side == Side::Left ? 0.0 : sizes.row);
        if (!isSmall) drawLetter(painter, QRectF(front, y, sizes.letter, sizes.row), side, fill);
        for (int e = 0; e < kForceElements; ++e) {
            const auto elementOf = [&](Flipper flipper) {
                return contacts ? contacts->flippers[indexOf(flipper)][static_cast<std::size_t>(e)]
                                : FlipperContacts::Element{};
            };
            const auto box = [&](double x) { return QRectF(x, y, sizes.box, sizes.row); };
            const int number = isSmall ? 0 : e + 1;
            drawElement(painter, box(front + sizes.letter + e * sizes.box), number,
                        elementOf(frontFlipper(side)), fill);
            if (!rear) continue;
            drawElement(painter, box(left + (kForceElements - 1 - e) * sizes.box), number,
                        elementOf(rearFlipper(side)), fill);
        }
    }
}

}  // namespace terratact
