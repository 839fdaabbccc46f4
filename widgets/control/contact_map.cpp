#include "widgets/control/contact_map.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/display/drive_text.h"
#include "app/display/place_text.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr int kBox = 14, kHeight = 17;  // [px at 100 %] of an element
constexpr int kLetter = 13, kLetterSize = 13, kNumberSize = 11, kGap = 6;  // [px at 100 %]
constexpr double kFullBar = 20.0;                                          // [N] fills the box

}  // namespace

ContactMap::ContactMap(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Contact by segment"));
    setContacts(std::nullopt);
}

bool ContactMap::hasRear() const
{
    return state_ && (state_->knows(Flipper::RearLeft) || state_->knows(Flipper::RearRight));
}

QSize ContactMap::sizeHint() const
{
    const int front = scaledLarge(kLetter) + kForceElements * scaledLarge(kBox);
    const int rear = hasRear() ? scaledLarge(kGap) + kForceElements * scaledLarge(kBox) : 0;
    return {front + rear + 1, 2 * scaledLarge(kHeight) + 1};
}

void ContactMap::setContacts(const std::optional<FlipperContacts>& state)
{
    const bool hadRear = hasRear();
    const QString spoken = state ? DriveText::contactsSpoken(*state) : tr("not known");
    if (state_ == state && spoken == accessibleDescription()) return;
    state_ = state;
    setAccessibleDescription(spoken);
    setTip(*this,
           tr("Elements 1 (pivot) to 6 (tip), filled where they touch the ground: %1").arg(spoken));
    if (hadRear != hasRear()) updateGeometry();
    update();
}

void ContactMap::setFill(const Fill& fill)
{
    fill_ = fill;
    update();
}

void ContactMap::drawElement(QPainter& painter, const QRectF& box, int number,
                             const FlipperContacts::Element& element) const
{
    const QColor& ink = fill_.text;
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
    painter.setPen(element.touches ? fill_.area : ink);
    QFont digits = font();
    digits.setPixelSize(scaledLarge(kNumberSize));
    digits.setBold(element.touches);
    painter.setFont(digits);
    painter.drawText(box, Qt::AlignCenter, QString::number(number));
}

void ContactMap::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const double box = scaledLarge(kBox), high = scaledLarge(kHeight);
    const double top = (height() - 1 - 2.0 * high) / 2.0;
    const bool rear = hasRear();
    const double front = rear ? kForceElements * box + scaledLarge(kGap) : 0.0;
    for (const Side side : {Side::Left, Side::Right}) {
        const double y = top + (side == Side::Left ? 0.0 : high);
        painter.setPen(fill_.text);
        QFont letters = font();
        letters.setPixelSize(scaledLarge(kLetterSize));
        painter.setFont(letters);
        painter.drawText(QRectF(front, y, scaledLarge(kLetter), high), Qt::AlignCenter,
                         sideLetter(side));
        for (int e = 0; e < kForceElements; ++e) {
            const auto elementOf = [&](Flipper flipper) {
                return state_ ? state_->flippers[indexOf(flipper)][static_cast<std::size_t>(e)]
                              : FlipperContacts::Element{};
            };
            const double ahead = front + scaledLarge(kLetter) + e * box;
            drawElement(painter, {ahead, y, box, high}, e + 1, elementOf(frontFlipper(side)));
            if (!rear) continue;
            const double behind = (kForceElements - 1 - e) * box;
            drawElement(painter, {behind, y, box, high}, e + 1, elementOf(rearFlipper(side)));
        }
    }
}

}  // namespace terratact
