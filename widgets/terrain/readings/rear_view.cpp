#include "widgets/terrain/readings/rear_view.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/display/format.h"
#include "widgets/base/palette.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr QSize kSize{128, 62};       // [px] at 100 %, the picture
constexpr QSize kFlat{82, 40};        // [px] at 100 %, the picture of a flat view with a gap
constexpr int kFlatGap = 6;           // [px] at 100 %
constexpr double kHalfWidthM = 0.42;  // [m] shown to both sides of the middle
constexpr double kBelowM = 0.14;      // [m] shown below the base
constexpr double kMinSaid = 0.05;     // [°] below which no side is up

bool isKnown(const RearView::Pose& pose)
{
    const auto isAngle = [](double angle) { return std::abs(angle) <= 2.0 * std::numbers::pi; };
    return isAngle(pose.roll) && isAngle(pose.frontLeft) && isAngle(pose.frontRight)
        && isAngle(pose.crossSlope.value_or(0.0));
}

/// Returns an angle with the side that is up: "3.2° L up".
QString tiltText(double radians)
{
    const double degrees = std::abs(radians) * 180.0 / std::numbers::pi;
    QString angle = format::plainAngle(std::abs(radians), 1);
    if (degrees < kMinSaid) return angle;
    return radians > 0.0 ? RearView::tr("%1 L up").arg(angle) : RearView::tr("%1 R up").arg(angle);
}

QString lineOf(const RearView::Pose& pose)
{
    return pose.crossSlope ? RearView::tr("cross slope %1").arg(tiltText(*pose.crossSlope))
                           : QString();
}

/// Returns an angle with the letter of the side that is up, in short: "L 3°".
QString shortTilt(double radians)
{
    const double degrees = std::abs(radians) * 180.0 / std::numbers::pi;
    QString angle = format::plainAngle(std::abs(radians), 0);
    if (degrees < 0.5) return angle;
    return QStringLiteral("↑%1 %2").arg(radians > 0.0 ? RearView::tr("L") : RearView::tr("R"),
                                        angle);
}

QString shortOf(const RearView::Pose& pose)
{
    return pose.crossSlope ? RearView::tr("cross %1").arg(shortTilt(*pose.crossSlope)) : QString();
}

QString spokenOf(const RearView::Pose& pose)
{
    QString roll = RearView::tr("roll %1").arg(tiltText(pose.roll));
    if (pose.crossSlope) roll += QStringLiteral("; ") + lineOf(pose);
    return RearView::tr("From behind: %1; front flippers L %2, R %3")
        .arg(roll, format::angle(pose.frontLeft), format::angle(pose.frontRight));
}

}  // namespace

RearView::RearView(const Shape& shape, QWidget* parent) : QWidget(parent), shape_(shape)
{
    setAccessibleName(tr("View from behind"));
    text_ = short_ = format::kNothing;
}

QSize RearView::sizeHint() const
{
    const int line = text_.isEmpty() ? 0 : fontMetrics().height();
    return {std::max(scaled(kSize.width()), fontMetrics().horizontalAdvance(text_)),
            scaled(kSize.height()) + line};
}

QSize RearView::minimumSizeHint() const
{
    const QString widest = tr("cross %1").arg(shortTilt(-0.7));
    return {scaled(kFlat.width()) + fontMetrics().horizontalAdvance(widest),
            std::max(scaled(kFlat.height()), fontMetrics().height())};
}

void RearView::setPose(const std::optional<Pose>& pose)
{
    const auto shown = pose && isKnown(*pose) ? pose : std::nullopt;
    if (shown == pose_) return;
    const bool hadSlope = pose_ && pose_->crossSlope;
    pose_ = shown;
    text_ = pose_ ? lineOf(*pose_) : QString(format::kNothing);
    short_ = pose_ ? shortOf(*pose_) : QString(format::kNothing);
    const QString spoken = pose_ ? spokenOf(*pose_) : tr("From behind: not known");
    setAccessibleDescription(spoken);
    setTip(*this, spoken);
    if (hadSlope != (pose_ && pose_->crossSlope)) updateGeometry();  // one line more or less
    update();
}

void RearView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetrics metrics = painter.fontMetrics();
    painter.setPen(pose_ ? theme().text : theme().muted);
    if (height() < sizeHint().height()) {  // flat
        const int beside = scaled(kFlat.width() - kFlatGap);
        painter.drawText(QRect(scaled(kFlat.width()), 0, width() - scaled(kFlat.width()), height()),
                         Qt::AlignLeft | Qt::AlignVCenter, short_);
        return drawPicture(painter, QRect(0, 0, beside, height()));
    }
    const int textHeight = text_.isEmpty() ? 0 : metrics.height();
    const bool fits = metrics.size(0, text_).width() <= width();
    painter.drawText(QRect(0, height() - textHeight, width(), textHeight), Qt::AlignCenter,
                     fits ? text_ : short_);
    drawPicture(painter, QRect(0, 0, width(), height() - textHeight));
}

void RearView::drawPicture(QPainter& painter, const QRect& place) const
{
    const int letter = painter.fontMetrics().horizontalAdvance(u'L') + 3;
    painter.setPen(theme().text);
    painter.drawText(place, Qt::AlignLeft | Qt::AlignBottom, tr("L"));
    painter.drawText(place, Qt::AlignRight | Qt::AlignBottom, tr("R"));
    if (!pose_) return;
    const double scale = (place.width() - 2.0 * letter) / (2.0 * kHalfWidthM);
    painter.setPen(QPen(theme().robotLine, 1.0, Qt::DashLine));
    const double middle = place.height() - kBelowM * scale;
    painter.drawLine(QPointF(letter, middle), QPointF(place.width() - letter, middle));
    painter.translate(place.width() / 2.0, middle);
    painter.setClipRect(QRectF(-place.width() / 2.0, -middle, place.width(), place.height()));
    painter.rotate(pose_->roll * 180.0 / std::numbers::pi);
    drawRobot(painter, scale);
}

/// Draws the robot around its base, y to the left and z up, seen from behind.
void RearView::drawRobot(QPainter& painter, double pixelsPerMetre) const
{
    painter.scale(pixelsPerMetre, -pixelsPerMetre);
    QPen pen(theme().robotLine, 1.0);
    pen.setCosmetic(true);
    painter.setPen(pen);
    const auto box = [&painter](double y, double width, double low, double high) {
        painter.drawRect(QRectF(-y - width / 2.0, low, width, std::max(high - low, 0.0)));
    };
    const auto flipper = [&](double y, double angle) {
        const double pivot = shape_.flipperPivotZ;
        const double tip = pivot + shape_.flipperLength * std::sin(angle - shape_.flipperTaper);
        box(y, shape_.flipperWidth,
            std::min(pivot - shape_.flipperPivotRadius, tip - shape_.flipperTipRadius),
            std::max(pivot + shape_.flipperPivotRadius, tip + shape_.flipperTipRadius));
    };
    painter.setBrush(theme().robotFlipper);
    flipper(shape_.flipperY, pose_->frontLeft);
    flipper(-shape_.flipperY, pose_->frontRight);
    painter.setBrush(theme().robotBody);
    box(0.0, 2.0 * shape_.trackY - shape_.trackWidth, shape_.bodyBottom, shape_.bodyTop);
    painter.setBrush(theme().robotTrack);
    box(shape_.trackY, shape_.trackWidth, shape_.trackBottom, shape_.trackTop);
    box(-shape_.trackY, shape_.trackWidth, shape_.trackBottom, shape_.trackTop);
}

}  // namespace terratact
