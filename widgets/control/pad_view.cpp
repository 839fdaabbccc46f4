#include "widgets/control/pad_view.h"

#include <QEvent>
#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/display/format.h"
#include "widgets/base/palette.h"

namespace terratact {
namespace {

constexpr int kLampRoom = 20, kBarRoom = 110, kPadGap = 12;  // [px at 100 %]
constexpr double kLampRadius = 5.0;                          // [px at 100 %]

void drawPadBar(QPainter& painter, const PadLine::Bar& bar, const QRectF& area)
{
    const Theme& colours = theme();
    const double zero = bar.fromMiddle ? area.center().x() : area.left();
    const double way = bar.fromMiddle ? area.width() / 2.0 : area.width();
    if (bar.deadZone > 0.0)
        painter.fillRect(
            QRectF(zero - bar.deadZone * way, area.top(), 2.0 * bar.deadZone * way, area.height()),
            colours.button.area);
    const double value = std::isfinite(bar.value) ? std::clamp(bar.value, -1.0, 1.0) : 0.0;
    const double end = value * way;
    painter.fillRect(QRectF(zero + std::min(end, 0.0), area.top() + area.height() * 0.2,
                            std::abs(end), area.height() * 0.6),
                     colours.accent);
    painter.setPen(colours.muted);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area);
    painter.drawLine(QPointF(zero, area.top()), QPointF(zero, area.bottom()));
}

}  // namespace

PadView::PadView(int columns, QWidget* parent) : QWidget(parent), columns_(columns) {}

int PadView::rows() const
{
    return (static_cast<int>(lines_.size()) + columns_ - 1) / columns_;
}

QFont PadView::boldFont() const
{
    QFont bold = font();
    bold.setBold(true);
    return bold;
}

int PadView::lineHeight() const
{
    return fontMetrics().height() + scaled(4);
}

int PadView::textWidth() const
{
    const QFontMetrics metrics(boldFont());
    int width = 0;
    for (const PadLine& line : lines_)
        width = std::max(width, metrics.horizontalAdvance(line.text)
                                    + scaled(line.bar ? kBarRoom : kLampRoom));
    return width;
}

QSize PadView::sizeHint() const
{
    return {columns_ * textWidth() + (columns_ - 1) * scaled(kPadGap), rows() * lineHeight()};
}

void PadView::setLines(std::vector<PadLine> lines)
{
    if (lines == lines_) return;
    const QSize before = sizeHint();
    lines_ = std::move(lines);
    QStringList spoken;
    for (const PadLine& line : lines_) {
        if (line.bar)
            spoken << line.text + QLatin1Char(' ') + format::number(line.bar->value, 1);
        else if (line.state != PadLine::State::Off)
            spoken << line.text;
    }
    setAccessibleDescription(spoken.join(QStringLiteral("; ")));
    if (sizeHint() != before) updateGeometry();
    update();
}

void PadView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        updateGeometry();
}

void PadView::draw(QPainter& painter, const PadLine& line, const QRectF& area) const
{
    using enum PadLine::State;
    const Theme& colours = theme();
    const QColor ink = line.state == On    ? colours.accent
                     : line.state == Waits ? colours.warning
                                           : colours.text;
    const double room = scaled(line.bar ? kBarRoom : kLampRoom);
    if (line.bar) {
        drawPadBar(painter, *line.bar,
                   QRectF(area.left() + 0.5, area.top() + scaled(3), room - scaled(10),
                          area.height() - scaled(6)));
    } else {
        const double radius = kLampRadius * scaled(100) / 100.0;
        painter.setPen(QPen(ink, 1.5));
        painter.setBrush(line.state == On ? QBrush(ink) : QBrush(Qt::NoBrush));
        painter.drawEllipse(QPointF(area.left() + radius + 1.0, area.center().y()), radius, radius);
    }
    painter.setPen(ink);
    painter.setFont(line.state == Off ? font() : boldFont());
    painter.drawText(area.adjusted(room, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, line.text);
}

void PadView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int high = lineHeight(), all = std::max(1, rows());
    const double wide = (width() + scaled(kPadGap)) / static_cast<double>(columns_);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        const int row = static_cast<int>(i) % all, column = static_cast<int>(i) / all;
        draw(painter, lines_[i], QRectF(column * wide, row * high, wide - scaled(kPadGap), high));
    }
}

}  // namespace terratact
