#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointF>
#include <QTimer>
#include <functional>
#include <optional>

class QTouchEvent;
class QWidget;

namespace terratact {

/// What fingers do in a picture. Positions are those of the widget [px].
struct PictureGestures {
    /// One finger: a tap is a press and a release at one place, a drag has moves between them.
    std::function<void(QPointF at)> pressed, moved, released;
    std::function<void(QPointF at)> tapped, tappedTwice;
    std::function<void(QPointF at)> hovered;  ///< a finger rests at one place
    /// Two fingers: they spread by `factor`, around the point that was at `from` and is now at `to`.
    std::function<void(double factor, QPointF from, QPointF to)> pinched;
};

/// Reads the touch events of a widget. One finger taps, drags, or rests for kLong. A second finger ends that and begins
/// to zoom and pan. The widget gets no mouse events of these touches.
class PictureTouch final : public QObject {
    Q_OBJECT
public:
    static constexpr int kLong = 500;  ///< [ms] until a resting finger hovers
    static constexpr int kStill = 12;  ///< [px at 100 %] a finger that moves less rests
    static constexpr int kApart = 24;  ///< [px at 100 %] least distance of fingers that zoom
    PictureTouch(QWidget& widget, PictureGestures gestures);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    enum class Doing : std::uint8_t { Nothing, Pressed, Dragging, Hovering, Pinching };
    /// Two fingers [px].
    struct Fingers {
        QPointF middle;
        double apart = 0.0;
    };
    void handle(const QTouchEvent& event);
    void begin(QPointF at);
    void move(QPointF at);
    void end(QPointF at);
    void letGo();

    QWidget& widget_;
    PictureGestures gestures_;
    QTimer long_;
    Doing doing_ = Doing::Nothing;
    QPointF began_, last_;
    std::optional<Fingers> fingers_;
    QElapsedTimer sinceTap_;
    QPointF tappedAt_;
};

}  // namespace terratact
