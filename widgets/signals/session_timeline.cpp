#include "widgets/signals/session_timeline.h"

#include <QEvent>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/display/format.h"
#include "widgets/base/palette.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr double kNear = 5.0;  // [px] distance at which the pointer hits a mark

QColor colourOf(TimelineSeverity severity)
{
    switch (severity) {
    case TimelineSeverity::Plain: return theme().ceiling;
    case TimelineSeverity::Good: return theme().good;
    case TimelineSeverity::Warning: return theme().warning;
    case TimelineSeverity::Bad: return theme().bad;
    case TimelineSeverity::Accent: return theme().accent;
    }
    return theme().text;
}

/// Returns the shape of a severity around (x, y): bar, circle, triangle, cross or diamond.
QPainterPath shapeOf(TimelineSeverity severity, double x, double y, double r)
{
    QPainterPath path;
    switch (severity) {
    case TimelineSeverity::Plain: path.addRect(x - 1.0, y - r, 2.0, 2.0 * r); break;
    case TimelineSeverity::Good: path.addEllipse(QPointF(x, y), 0.8 * r, 0.8 * r); break;
    case TimelineSeverity::Warning:
        path.addPolygon(QPolygonF({{x, y - r}, {x + r, y + r}, {x - r, y + r}, {x, y - r}}));
        break;
    case TimelineSeverity::Bad:
        path.addPolygon(QPolygonF({{x - r, y - r}, {x + r, y - r}, {x, y + r}, {x - r, y - r}}));
        break;
    case TimelineSeverity::Accent:
        path.addPolygon(QPolygonF({{x, y - r}, {x + r, y}, {x, y + r}, {x - r, y}, {x, y - r}}));
        break;
    }
    return path;
}

/// Returns false beyond thirty years, where neighbouring pixels could round to the same number.
bool isTime(double seconds)
{
    return std::abs(seconds) <= 1e9;
}

bool isSound(const TimelineSpan& span)
{
    return isTime(span.first) && isTime(span.last) && span.first <= span.last;
}

}  // namespace

double timeStep(double span, double most)
{
    static constexpr std::array kSteps{0.001, 0.002, 0.005, 0.01,  0.02,   0.05,  0.1,  0.2,
                                       0.5,   1.0,   2.0,   5.0,   10.0,   15.0,  30.0, 60.0,
                                       120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0};
    for (const double step : kSteps)
        if (span / step <= most) return step;
    return 3600.0 * std::ceil(span / most / 3600.0);
}

QString timeText(double seconds, double step)
{
    if (!isTime(seconds)) return format::kNothing;
    const int decimals = step >= 1.0 ? 0 : step >= 0.1 ? 1 : step >= 0.01 ? 2 : 3;
    const double unit = std::pow(10.0, decimals);
    const auto whole = static_cast<qint64>(std::llround(std::abs(seconds) * unit));
    const auto perSecond = static_cast<qint64>(unit);
    const qint64 total = whole / perSecond, fraction = whole % perSecond;
    QString text = QStringLiteral("%1:%2:%3")
                       .arg(total / 3600)
                       .arg(total / 60 % 60, 2, 10, QLatin1Char('0'))
                       .arg(total % 60, 2, 10, QLatin1Char('0'));
    if (decimals > 0) text += QStringLiteral(".%1").arg(fraction, decimals, 10, QLatin1Char('0'));
    return seconds < 0.0 && whole > 0 ? QChar(0x2212) + text : text;
}

SessionTimeline::SessionTimeline(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Timeline"));
    setMouseTracking(false);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

QSize SessionTimeline::sizeHint() const
{
    return {700,
            scaled(22) + static_cast<int>(timeline_.lanes.size()) * scaled(dense_ ? 14 : 17) + 4};
}

QSize SessionTimeline::minimumSizeHint() const
{
    return {300, sizeHint().height()};
}

void SessionTimeline::setTimeline(const Timeline& timeline)
{
    if (timeline_ == timeline) return;
    const bool all = first_ <= timeline_.begin && last_ >= timeline_.end;
    const bool sameLanes = timeline_.lanes.size() == timeline.lanes.size();
    timeline_ = timeline;
    if (!isTime(timeline_.begin)) timeline_.begin = 0.0;
    if (!isTime(timeline_.end) || timeline_.end < timeline_.begin + kMinSpan)
        timeline_.end = timeline_.begin + kMinSpan;
    measureNames();
    if (all) showAll();
    if (!sameLanes) updateGeometry();
    describe();
    update();
}

void SessionTimeline::setDense(bool dense)
{
    if (dense == dense_) return;
    dense_ = dense;
    updateGeometry();
}

void SessionTimeline::setPlayhead(double seconds)
{
    if (!isTime(seconds) || seconds == playhead_) return;
    const bool wasSeen = playhead_ >= first_ && playhead_ <= last_;
    const bool isSeen = std::abs(pixelOf(seconds) - pixelOf(drawnPlayhead_)) >= 1.0;
    playhead_ = seconds;
    if (wasSeen && (seconds < first_ || seconds > last_)) {
        const double span = last_ - first_;
        const double from = seconds > last_ ? seconds - 0.1 * span : seconds - 0.9 * span;
        showSpan(from, from + span);
    }
    if (!isSeen) return;
    drawnPlayhead_ = seconds;
    describe();
    update();
}

void SessionTimeline::setCursors(std::optional<double> a, std::optional<double> b)
{
    if (a_ == a && b_ == b) return;
    a_ = a;
    b_ = b;
    update();
}

void SessionTimeline::showSpan(double first, double last)
{
    if (!isTime(first) || !isTime(last)) return;
    const double all = timeline_.end - timeline_.begin;
    const double span = std::min(std::max(last - first, kMinSpan), all);
    first_ = std::clamp(first, timeline_.begin, timeline_.end - span);
    last_ = first_ + span;
    emit zoomed();
    update();
}

void SessionTimeline::showAll()
{
    showSpan(timeline_.begin, timeline_.end);
}

void SessionTimeline::zoom(double factor, double at)
{
    if (!(factor > 0.0 && factor < 1e12) || !isTime(at)) return;
    const double where = std::clamp(at, first_, last_);
    const double span = std::clamp((last_ - first_) / factor, kMinSpan,
                                   std::max(kMinSpan, timeline_.end - timeline_.begin));
    const double share = (where - first_) / (last_ - first_);
    showSpan(where - share * span, where + (1.0 - share) * span);
}

void SessionTimeline::measureNames()
{
    names_ = 0.0;
    for (const TimelineLane& lane : timeline_.lanes)
        names_ = std::max(names_, 14.0 + fontMetrics().horizontalAdvance(lane.name));
}

QRectF SessionTimeline::plot() const
{
    const double names = names_, scale = scaled(20);
    return {names, scale, std::max(1.0, width() - names - 8.0),
            std::max(1.0, height() - scale - 3.0)};
}

double SessionTimeline::laneHeight() const
{
    return plot().height() / static_cast<double>(std::max<qsizetype>(1, timeline_.lanes.size()));
}

double SessionTimeline::pixelOf(double seconds) const
{
    const QRectF area = plot();
    return area.left() + (seconds - first_) / (last_ - first_) * area.width();
}

double SessionTimeline::secondsAt(double pixel) const
{
    const QRectF area = plot();
    return first_ + (pixel - area.left()) / area.width() * (last_ - first_);
}

QString SessionTimeline::textAt(QPointF point) const
{
    const QRectF area = plot();
    if (!area.contains(point)) return {};
    const double at = secondsAt(point.x());
    const double near = kNear / area.width() * (last_ - first_);
    const auto row = static_cast<qsizetype>((point.y() - area.top()) / laneHeight());
    QStringList texts;
    if (row < timeline_.lanes.size()) {
        const TimelineLane& lane = timeline_.lanes[row];
        for (const TimelineMark& mark : lane.marks)
            if (std::abs(mark.time - at) <= near && texts.size() < 8)
                texts << timeText(mark.time) + QStringLiteral("  ") + mark.text;
        for (const TimelineSpan& span : lane.spans)
            if (span.first - near <= at && at <= span.last + near && texts.size() < 8)
                texts
                    << tr("%1 – %2  %3").arg(timeText(span.first), timeText(span.last), span.text);
    }
    for (const TimelineSpan& gap : timeline_.gaps)
        if (gap.first - near <= at && at <= gap.last + near && texts.size() < 8)
            texts << tr("%1 – %2  %3").arg(timeText(gap.first), timeText(gap.last), gap.text);
    return texts.join(QLatin1Char('\n'));
}

void SessionTimeline::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = plot();
    painter.fillRect(area, theme().card);
    paintScale(painter);
    for (int lane = 0; lane < timeline_.lanes.size(); ++lane) paintLane(painter, lane);
    painter.save();
    painter.setClipRect(area);
    paintGaps(painter);
    painter.restore();
    painter.setPen(theme().cardBorder);
    painter.drawRect(area);
    if (a_) paintCursor(painter, *a_, QStringLiteral("A"));
    if (b_) paintCursor(painter, *b_, QStringLiteral("B"));
    paintPlayhead(painter);
}

void SessionTimeline::paintScale(QPainter& painter) const
{
    const QRectF area = plot();
    const double span = last_ - first_;
    const double step = timeStep(span, area.width() / scaled(86));
    painter.setFont(font());
    for (double k = std::ceil(first_ / step); k * step <= last_; k += 1.0) {
        const double x = pixelOf(k * step);
        painter.setPen(theme().grid);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(theme().muted);
        const QRectF room(x - scaled(60), 0.0, 2.0 * scaled(60), area.top());
        if (room.left() + scaled(24) > 0.0 && room.right() - scaled(24) < width())
            painter.drawText(room, Qt::AlignCenter, timeText(k * step, step));
    }
}

void SessionTimeline::paintLane(QPainter& painter, int index) const
{
    const TimelineLane& lane = timeline_.lanes[index];
    const QRectF area = plot();
    const double height = laneHeight(), top = area.top() + index * height;
    painter.setPen(theme().text);
    painter.drawText(QRectF(2.0, top, area.left() - 8.0, height), Qt::AlignRight | Qt::AlignVCenter,
                     lane.name);
    painter.setPen(theme().grid);
    painter.drawLine(QPointF(area.left(), top), QPointF(area.right(), top));
    painter.save();
    painter.setClipRect(area);
    painter.setPen(Qt::NoPen);
    for (const TimelineSpan& span : lane.spans) {
        if (!isSound(span) || span.last < first_ || span.first > last_) continue;
        const double from = std::max(pixelOf(span.first), area.left() - 2.0);
        const double to = std::min(pixelOf(span.last), area.right() + 2.0);
        QColor colour = colourOf(span.severity);
        colour.setAlphaF(0.55F);
        // Bad spans are tall and others low, so that colour is not the only cue.
        const double share = span.severity == TimelineSeverity::Bad ? 0.9 : 0.5;
        painter.fillRect(QRectF(from, top + 0.5 * (1.0 - share) * height, std::max(to - from, 1.5),
                                share * height),
                         colour);
    }
    double drawn = -1e9;  // marks on the same pixel are drawn once
    for (const TimelineMark& mark : lane.marks) {
        if (!isTime(mark.time) || mark.time < first_ || mark.time > last_) continue;
        const double x = pixelOf(mark.time);
        if (std::abs(x - drawn) < 0.5 && mark.severity == TimelineSeverity::Plain) continue;
        drawn = x;
        painter.fillPath(shapeOf(mark.severity, x, top + 0.5 * height, 0.36 * height),
                         colourOf(mark.severity));
    }
    painter.restore();
}

void SessionTimeline::paintGaps(QPainter& painter) const
{
    const QRectF area = plot();
    for (const TimelineSpan& gap : timeline_.gaps) {
        if (!isSound(gap) || gap.last < first_ || gap.first > last_) continue;
        const double from = std::max(pixelOf(gap.first), area.left() - 2.0);
        const double to = std::min(pixelOf(gap.last), area.right() + 2.0);
        const QRectF room(from, area.top(), std::max(to - from, 2.0), area.height());
        painter.fillRect(room, theme().window);
        painter.fillRect(room, QBrush(colourOf(gap.severity), Qt::BDiagPattern));
    }
}

void SessionTimeline::paintCursor(QPainter& painter, double seconds, const QString& name) const
{
    const QRectF area = plot();
    if (!(seconds >= first_ && seconds <= last_)) return;
    const double x = pixelOf(seconds);
    painter.setPen(QPen(theme().contact, 2.0, Qt::DashLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    const QRectF badge(x - 8.0, area.top() - scaled(16), 16.0, scaled(15));
    painter.fillRect(badge, theme().contact);
    painter.setPen(theme().card);
    painter.drawText(badge, Qt::AlignCenter, name);
}

void SessionTimeline::paintPlayhead(QPainter& painter) const
{
    const QRectF area = plot();
    if (playhead_ < first_ || playhead_ > last_) return;
    const double x = pixelOf(playhead_);
    painter.setPen(QPen(theme().text, 2.0));
    painter.drawLine(QPointF(x, area.top() - 3.0), QPointF(x, area.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().text);
    painter.drawPolygon(
        QPolygonF({{x - 6.0, area.top() - 9.0}, {x + 6.0, area.top() - 9.0}, {x, area.top()}}));
}

void SessionTimeline::mousePressEvent(QMouseEvent* event)
{
    grabbedAt_ = secondsAt(event->position().x());
    if (event->button() == Qt::LeftButton)
        emit seekWanted(std::clamp(grabbedAt_, timeline_.begin, timeline_.end));
}

void SessionTimeline::mouseMoveEvent(QMouseEvent* event)
{
    const double at = secondsAt(event->position().x());
    if (event->buttons() & Qt::LeftButton)
        emit seekWanted(std::clamp(at, timeline_.begin, timeline_.end));
    else if (event->buttons() & (Qt::RightButton | Qt::MiddleButton))
        showSpan(first_ + grabbedAt_ - at, last_ + grabbedAt_ - at);
}

void SessionTimeline::wheelEvent(QWheelEvent* event)
{
    const QPoint turned = event->angleDelta();
    const double steps = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
    if (event->modifiers() & Qt::ShiftModifier) {
        const double by = -0.1 * steps * (last_ - first_);
        showSpan(first_ + by, last_ + by);
    } else {
        zoom(std::pow(1.25, steps), secondsAt(event->position().x()));
    }
    event->accept();
}

bool SessionTimeline::event(QEvent* event)
{
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange) {
        measureNames();
        updateGeometry();
    }
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QString text = textAt(help->pos());
        if (text.isEmpty())
            QToolTip::hideText();
        else
            showTip(help->globalPos(), text, this);
        return true;
    }
    return QWidget::event(event);
}

void SessionTimeline::describe()
{
    setAccessibleDescription(
        tr("%1 of %2")
            .arg(timeText(playhead_ - timeline_.begin), timeText(timeline_.end - timeline_.begin)));
}

}  // namespace terratact
