#pragma once

#include <QWidget>
#include <optional>

namespace terratact {

/// Small view of the robot from behind: body, both tracks and both front flippers, left (L) at the left. Below it
/// stands the cross slope of the ground ahead in degrees, where it is known. In its minimum size the view
/// is flat: the same stands in short beside a smaller picture. Takes values, emits nothing.
class RearView final : public QWidget {
    Q_OBJECT
public:
    /// Angles [rad]. Left side up is positive for the roll and the cross slope, tip up for the flippers.
    struct Pose {
        double roll = 0.0;
        double frontLeft = 0.0, frontRight = 0.0;
        std::optional<double> crossSlope{};  ///< of the ground ahead; empty: not known
        bool operator==(const Pose&) const = default;
    };

    /// Lengths [m] of the robot, y from its middle and z from its base.
    struct Shape {
        double trackY = 0.0, trackWidth = 0.0, flipperY = 0.0, flipperWidth = 0.0;
        double trackBottom = 0.0, trackTop = 0.0, bodyBottom = 0.0, bodyTop = 0.0;
        double flipperPivotZ = 0.0, flipperPivotRadius = 0.0, flipperTipRadius = 0.0;
        double flipperLength = 0.0;  ///< from the pivot to the tip circle
        double flipperTaper = 0.0;   ///< [rad] of the flipper's axis above its lower edge
    };

    explicit RearView(const Shape& shape, QWidget* parent = nullptr);

    /// Shows a pose; empty: nothing is known, or it is too old. Angles beyond a turn count as unknown.
    void setPose(const std::optional<Pose>& pose);

    QString text() const { return text_; }  ///< the line below the picture
    /// Returns the line in short: "cross ↑L 3°".
    QString shortText() const { return short_; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void drawPicture(QPainter& painter, const QRect& place) const;
    void drawRobot(QPainter& painter, double pixelsPerMetre) const;

    Shape shape_;
    std::optional<Pose> pose_;
    QString text_, short_;
};

}  // namespace terratact
