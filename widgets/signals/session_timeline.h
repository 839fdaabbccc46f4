#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <optional>

namespace terratact {

/// How much a span or a mark of the timeline matters; each has a shape of its own.
enum class TimelineWeight : std::uint8_t { Plain, Good, Doubt, Bad, Accent };

/// Something that lasted.  [s] of the session.
struct TimelineSpan {
    double first = 0.0, last = 0.0;
    TimelineWeight weight = TimelineWeight::Plain;
    QString text{};
    bool operator==(const TimelineSpan&) const = default;
};

/// Something that happened at a time [s].
struct TimelineMark {
    double time = 0.0;
    TimelineWeight weight = TimelineWeight::Plain;
    QString text{};
    bool operator==(const TimelineMark&) const = default;
};

struct TimelineLane {
    QString name;
    QList<TimelineSpan> spans{};
    QList<TimelineMark> marks{};
    bool operator==(const TimelineLane&) const = default;
};

/// A session as lanes below each other.  gaps: of every lane, drawn hatched across all and never bridged.
struct Timeline {
    double begin = 0.0, end = 0.0;  ///< [s]
    QList<TimelineLane> lanes{};
    QList<TimelineSpan> gaps{};
    bool operator==(const Timeline&) const = default;
};

/// Draws a session's timeline with the playhead, and the cursors A and B.  A click or drag says where to go, the
/// wheel zooms at the mouse, a drag with the right button, or the wheel with Shift, moves what is shown.  What is
/// not finite is not drawn.  GUI thread only.
class SessionTimeline final : public QWidget {
    Q_OBJECT
public:
    explicit SessionTimeline(QWidget* parent = nullptr);

    void setTimeline(
        const Timeline& timeline);     ///< what is shown of it stays, unless that was all of it
    void setDense(bool dense);         ///< lower lanes, where there is little room
    void setPlayhead(double seconds);  ///< kept in view where it was so before
    void setCursors(std::optional<double> a, std::optional<double> b);
    void showSpan(double first, double last);  ///< at least kMinSpan of it, no more than there is
    void showAll();
    void zoom(double factor, double at);  ///< factor above 1: closer; at: [s] stays where it is

    double first() const { return first_; }
    double last() const { return last_; }
    double playhead() const { return playhead_; }
    /// Pixel column of a time [s], and back; exact within what is shown.
    double pixelOf(double seconds) const;
    double secondsAt(double pixel) const;
    /// What is to be read under a point; empty: nothing.
    QString textAt(QPointF point) const;

    static constexpr double kMinSpan = 0.02;  ///< [s] that can be shown

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void seekWanted(double seconds);
    void zoomed();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;

private:
    QRectF plot() const;  ///< without names and scale
    double laneHeight() const;
    void paintLane(QPainter& painter, int lane) const;
    void paintScale(QPainter& painter) const;
    void paintGaps(QPainter& painter) const;
    void paintCursor(QPainter& painter, double seconds, const QString& name) const;
    void paintPlayhead(QPainter& painter) const;
    void measureNames();
    void tell();  ///< to who cannot see it

    Timeline timeline_;
    bool dense_ = false;
    double first_ = 0.0, last_ = 1.0;
    double names_ = 0.0;  ///< [px] width of the lanes' names
    double playhead_ = 0.0, drawnPlayhead_ = 0.0;
    std::optional<double> a_, b_;
    double grabbedAt_ = 0.0;
};

/// "1:02:03.45", as short as `step` [s] between two of them allows; NaN reads "--".
QString timeWords(double seconds, double step = 0.001);

}  // namespace terratact
