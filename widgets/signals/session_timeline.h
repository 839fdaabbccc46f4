#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <optional>

namespace terratact {

/// Severity of a span or mark; each has its own shape.
enum class TimelineSeverity : std::uint8_t { Plain, Good, Warning, Bad, Accent };

/// Something with a duration [s of the session].
struct TimelineSpan {
    double first = 0.0, last = 0.0;
    TimelineSeverity severity = TimelineSeverity::Plain;
    QString text{};
    bool operator==(const TimelineSpan&) const = default;
};

/// Something at one time [s of the session].
struct TimelineMark {
    double time = 0.0;
    TimelineSeverity severity = TimelineSeverity::Plain;
    QString text{};
    bool operator==(const TimelineMark&) const = default;
};

struct TimelineLane {
    QString name;
    QList<TimelineSpan> spans{};
    QList<TimelineMark> marks{};
    bool operator==(const TimelineLane&) const = default;
};

/// A session as lanes below each other. gaps: missing data in all lanes, drawn hatched and never bridged.
struct Timeline {
    double begin = 0.0, end = 0.0;  ///< [s]
    QList<TimelineLane> lanes{};
    QList<TimelineSpan> gaps{};
    bool operator==(const Timeline&) const = default;
};

/// Draws a session's timeline with the playhead and the cursors A and B. A click or drag requests a time; the wheel
/// zooms at the pointer. A drag with the right button, or the wheel with Shift, scrolls. Values that are not finite are
/// not drawn. GUI thread only.
class SessionTimeline final : public QWidget {
    Q_OBJECT
public:
    explicit SessionTimeline(QWidget* parent = nullptr);

    /// Keeps the visible range, unless all was visible.
    void setTimeline(const Timeline& timeline);
    void setDense(bool dense);         ///< lower lanes for small heights
    void setPlayhead(double seconds);  ///< scrolls with the playhead if it was visible
    void setCursors(std::optional<double> a, std::optional<double> b);
    void showSpan(double first, double last);  ///< clamped to kMinSpan and to the session
    void showAll();
    void zoom(double factor, double at);  ///< factor > 1 zooms in; `at` [s] keeps its place

    double first() const { return first_; }
    double last() const { return last_; }
    /// Convert a time [s] to a pixel column and back; exact within the visible range.
    double pixelOf(double seconds) const;
    double secondsAt(double pixel) const;
    /// Returns the text under a point; empty: nothing is there.
    QString textAt(QPointF point) const;

    static constexpr double kMinSpan = 0.02;  ///< [s] smallest visible range

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
    QRectF plot() const;  ///< area without lane names and scale
    double laneHeight() const;
    void paintLane(QPainter& painter, int lane) const;
    void paintScale(QPainter& painter) const;
    void paintGaps(QPainter& painter) const;
    void paintCursor(QPainter& painter, double seconds, const QString& name) const;
    void paintPlayhead(QPainter& painter) const;
    void measureNames();
    void describe();  ///< describes the timeline to a screen reader

    Timeline timeline_;
    bool dense_ = false;
    double first_ = 0.0, last_ = 1.0;
    double names_ = 0.0;  ///< [px] width of the lane names
    double playhead_ = 0.0, drawnPlayhead_ = 0.0;
    std::optional<double> a_, b_;
    double grabbedAt_ = 0.0;
};

/// Formats a time as "1:02:03.45", with as few decimals as a step of `step` [s] needs; NaN reads "--".
QString timeText(double seconds, double step = 0.001);

/// Returns a round step [s] of a time scale with at most `most` steps in `span` [s].
double timeStep(double span, double most);

}  // namespace terratact
