#include "widgets/control/drive_cell.h"

#include <QApplication>
#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "widgets/base/palette.h"
#include "widgets/control/angle_gauge.h"

namespace terratact {
namespace {

// [px at 100 %]
constexpr int kValueSize = 20, kShortValueSize = 18, kCaptionSize = 12;
constexpr int kGauge = 5;           // height
constexpr int kEdge = 4, kTop = 1;  // inside of a cell
constexpr int kBeside = 6;          // between the parts of a cell
constexpr int kCorner = 4;

QFont sized(int pixels, bool isBold)
{
    QFont font = QApplication::font();
    font.setPixelSize(scaledLarge(pixels));
    font.setBold(isBold);
    return font;
}

/// The caption on a fill is bold.
QFont captionFont(bool isBold)
{
    return sized(kCaptionSize, isBold);
}

QFont valueFont(DriveDetail detail)
{
    return sized(detail == DriveDetail::Short ? kShortValueSize : kValueSize, true);
}

int widestOf(const QFont& font, const QStringList& texts)
{
    const QFontMetrics metrics(font);
    int widest = 0;
    for (const QString& text : texts) widest = std::max(widest, metrics.horizontalAdvance(text));
    return widest;
}

Fill fillOf(const QString& level)
{
    if (level == QLatin1String("amber")) return theme().open;
    if (level == QLatin1String("red")) return theme().blocked;
    if (level == QLatin1String("contact")) return theme().felt;
    return {theme().card, theme().text};
}

double widthOf(const DriveCell::Line& line)
{
    return QFontMetricsF(line.font).horizontalAdvance(line.text);
}

/// Draws a line. A text that does not fit gets a smaller font, down to two thirds of the size.
void draw(QPainter& painter, const DriveCell::Line& line)
{
    QFont font = line.font;
    const double share = line.area.width() / std::max(widthOf(line), 1.0);
    if (share < 1.0)
        font.setPixelSize(static_cast<int>(font.pixelSize() * std::max(share, 2.0 / 3.0)));
    painter.setFont(font);
    painter.drawText(line.area, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, line.text);
}

}  // namespace

DriveCell::DriveCell(Kind kind, Widest widest, QWidget* parent)
    : QWidget(parent), kind_(kind), widest_(std::move(widest))
{
}

void DriveCell::setContent(const Content& content)
{
    if (content == content_) return;
    content_ = content;
    update();
}

void DriveCell::setDetail(DriveDetail detail)
{
    if (detail == detail_) return;
    detail_ = detail;
    update();
}

ContactMap DriveCell::map(DriveDetail detail) const
{
    return {content_.contacts, detail == DriveDetail::Short};
}

ContactMap DriveCell::map() const
{
    return map(detail_);
}

int DriveCell::widthFor(DriveDetail detail) const
{
    const bool isShort = detail == DriveDetail::Short;
    const int caption =
        widestOf(captionFont(true), isShort ? widest_.shortCaptions : widest_.captions);
    const bool isBrief = isShort && !widest_.shortValues.isEmpty();
    int value = widestOf(valueFont(detail), isBrief ? widest_.shortValues : widest_.values);
    if (detail == DriveDetail::Limits && kind_ == Kind::Angle)
        value += scaledLarge(kBeside) + widestOf(captionFont(true), {widest_.limits});
    const int beside =
        kind_ == Kind::Contact ? scaledLarge(kBeside) + map(detail).size().width() : 0;
    // The small map stands beside the value, the whole one beside the caption, too.
    const int words =
        isShort ? std::max(caption, value + beside) : std::max(caption, value) + beside;
    return words + 2 * scaledLarge(kEdge);
}

int DriveCell::heightOfAll()
{
    const int caption = QFontMetrics(captionFont(true)).height();
    const int value =
        QFontMetrics(valueFont(DriveDetail::Words)).ascent();  // digits do not descend
    return std::max(caption + value, ContactMap{}.size().height()) + scaledLarge(kGauge)
         + 2 * scaledLarge(kTop);
}

QRectF DriveCell::inside() const
{
    const int edge = scaledLarge(kEdge), top = scaledLarge(kTop);
    return QRectF(rect()).adjusted(edge, top, -edge, -top);
}

/// Returns the areas of the caption and of the value.
std::pair<QRectF, QRectF> DriveCell::areas() const
{
    QRectF caption = inside(), value = caption;
    caption.setHeight(QFontMetrics(captionFont(true)).height());
    value.setTop(caption.bottom());
    value.setBottom(value.bottom()
                    - scaledLarge(kGauge));  // of every cell, so that all stand in line
    if (kind_ == Kind::Contact) {
        const double room = map().size().width() + scaledLarge(kBeside);
        value.setRight(value.right() - room);
        if (detail_ != DriveDetail::Short) caption.setRight(caption.right() - room);
    }
    return {caption, value};
}

std::vector<DriveCell::Line> DriveCell::lines() const
{
    const QFont words = captionFont(!content_.level.isEmpty());
    const auto [caption, value] = areas();
    const bool isShort = detail_ == DriveDetail::Short;
    std::vector<Line> lines{
        {caption, words, isShort ? content_.shortCaption : content_.caption},
        {value, valueFont(detail_),
         isShort && !content_.shortValue.isEmpty() ? content_.shortValue : content_.value}};
    if (detail_ != DriveDetail::Limits || content_.limits.isEmpty()) return lines;
    Line limits{value, words, content_.limits};
    limits.area.setLeft(value.left() + widthOf(lines.back()) + scaledLarge(kBeside));
    lines.push_back(std::move(limits));
    return lines;
}

bool DriveCell::fits() const
{
    return std::ranges::all_of(
        lines(), [](const Line& line) { return widthOf(line) <= line.area.width() + 0.5; });
}

void DriveCell::drawPicture(QPainter& painter, const Fill& fill) const
{
    QRectF area = inside();
    if (kind_ == Kind::Contact) {
        if (detail_ == DriveDetail::Short) area.setTop(areas().first.bottom());
        map().draw(painter, area, fill);
    } else if (kind_ == Kind::Angle) {
        area.setTop(area.bottom() - scaledLarge(kGauge));
        drawAngleGauge(painter, area, content_.angle, fill.text);
    }
}

void DriveCell::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const Fill fill = fillOf(content_.level);
    if (!content_.level.isEmpty()) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill.area);
        painter.drawRoundedRect(rect(), kCorner, kCorner);
        painter.setRenderHint(QPainter::Antialiasing, false);
    }
    painter.setPen(fill.text);
    for (const Line& line : lines()) draw(painter, line);
    drawPicture(painter, fill);
}

}  // namespace terratact
