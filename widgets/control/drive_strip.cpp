#include "widgets/control/drive_strip.h"

#include <QApplication>
#include <QEvent>
#include <QFontMetrics>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <numbers>
#include <utility>

#include "app/display/drive_text.h"
#include "app/display/format.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/angle_gauge.h"
#include "widgets/control/contact_map.h"

namespace terratact {
namespace {

constexpr int kValueSize = 20, kCaptionSize = 12;  // [px at 100 %], equal to the style sheet
constexpr int kEdge = 5;                           // [px] inside of a cell, left and right
constexpr int kFrame = 3;                          // [px] of the strip around the cells
constexpr int kBeside = 6;                         // [px] between the parts of a cell

QString nameOf(DriveStrip::Cell cell)
{
    switch (cell) {
    case DriveStrip::Pitch: return DriveStrip::tr("pitch");
    case DriveStrip::Roll: return DriveStrip::tr("roll");
    case DriveStrip::Contact: return DriveStrip::tr("contact");
    case DriveStrip::Speed: return DriveStrip::tr("speed");
    case DriveStrip::Way: return DriveStrip::tr("since estimate");
    case DriveStrip::FeltTo: return DriveStrip::tr("felt to");
    case DriveStrip::kCells: break;
    }
    return {};
}

QString tipOf(DriveStrip::Cell cell)
{
    switch (cell) {
    case DriveStrip::Contact:
        return DriveStrip::tr(
            "The element of each flipper that touches the ground hardest: its side "
            "and its number, 1 (pivot) to 6 (tip)");
    case DriveStrip::Speed: return DriveStrip::tr("Along the tracks, over the last half second");
    case DriveStrip::Way: return DriveStrip::tr("Distance rolled since the last estimate");
    case DriveStrip::FeltTo:
        return DriveStrip::tr(
            "The ground is felt up to here, forward from the IMU, on both sides; \"!\" where the "
            "tracks are about to leave felt ground");
    default: return {};
    }
}

QFont sizedBold(int pixels)
{
    QFont font = QApplication::font();
    font.setPixelSize(scaledLarge(pixels));
    font.setBold(true);
    return font;
}

int widestOf(const QFont& font, const QStringList& texts)
{
    int widest = 0;
    for (const QString& text : texts)
        widest = std::max(widest, QFontMetrics(font).horizontalAdvance(text));
    return widest;
}

QString withMark(const QString& name, const QString& mark)
{
    return mark.isEmpty() ? name : name + QLatin1Char(' ') + mark;
}

/// Returns the widest captions of a cell.
QStringList captionsOf(DriveStrip::Cell cell)
{
    const QString name = nameOf(cell);
    switch (cell) {
    case DriveStrip::Pitch:
    case DriveStrip::Roll:
        return {withMark(name, DriveText::level(AttitudeLevel::Amber)),
                withMark(name, DriveText::level(AttitudeLevel::Red))};
    case DriveStrip::Contact: return {name, DriveStrip::tr("● CONTACT") + " 20 N"};
    case DriveStrip::FeltTo: return {withMark(name, QStringLiteral("!"))};
    default: return {name};
    }
}

QStringList valuesOf(DriveStrip::Cell cell)
{
    switch (cell) {
    case DriveStrip::Pitch:
    case DriveStrip::Roll: return {format::degrees(-88.8 * std::numbers::pi / 180.0)};
    case DriveStrip::Contact: return {DriveText::contacts({}), QStringLiteral("L5 R5")};
    case DriveStrip::Speed: return {DriveText::speed(-0.88)};
    case DriveStrip::Way: return {QStringLiteral("88.88 m")};
    case DriveStrip::FeltTo: return {QStringLiteral("+8.88 m")};
    case DriveStrip::kCells: break;
    }
    return {};
}

QString levelName(AttitudeLevel level)
{
    switch (level) {
    case AttitudeLevel::Level: return {};
    case AttitudeLevel::Amber: return QStringLiteral("amber");
    case AttitudeLevel::Red: return QStringLiteral("red");
    }
    return {};
}

Fill fillOf(const QString& level)
{
    if (level == QLatin1String("amber")) return theme().open;
    if (level == QLatin1String("red")) return theme().blocked;
    if (level == QLatin1String("contact")) return theme().felt;
    return {theme().card, theme().text};
}

void setLevel(QFrame& frame, const QString& level)
{
    if (frame.property("level").toString() == level) return;
    QList<QWidget*> parts = frame.findChildren<QWidget*>();
    parts << &frame;
    for (QWidget* const part : std::as_const(parts)) {
        part->setProperty("level", level);
        part->style()->unpolish(part);
        part->style()->polish(part);
    }
}

}  // namespace

DriveStrip::DriveStrip(QWidget* parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("driveStrip"));
    setProperty("card", true);
    setAccessibleName(tr("Driving"));
    grid_ = new QGridLayout(this);
    grid_->setContentsMargins(kFrame, kFrame, kFrame, kFrame);
    grid_->setHorizontalSpacing(0);
    grid_->setVerticalSpacing(0);
    for (int cell = 0; cell < kCells; ++cell)
        cells_[static_cast<std::size_t>(cell)] = newCell(static_cast<Cell>(cell));
    place();
    resizeToFont();
    setViewState({});
}

DriveStrip::Parts DriveStrip::newCell(Cell cell)
{
    Parts parts;
    parts.frame = new QFrame(this);
    parts.frame->setProperty("cell", true);
    parts.caption = new PlainLabel(nameOf(cell), parts.frame);
    parts.caption->setProperty("part", "caption");
    parts.value = new PlainLabel(parts.frame);
    parts.value->setProperty("part", "value");
    parts.value->setAccessibleName(nameOf(cell));
    setTip(*parts.value, tipOf(cell));
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(parts.caption);
    auto* row = new QHBoxLayout;
    row->setSpacing(kBeside);
    row->addWidget(parts.value);
    if (cell == Pitch || cell == Roll) {
        parts.limits = new PlainLabel(parts.frame);
        parts.limits->setProperty("part", "caption");
        parts.limits->setAccessibleName(cell == Pitch ? tr("limits of the pitch")
                                                      : tr("limits of the roll"));
        parts.gauge = new AngleGauge(parts.frame);
        row->addWidget(parts.limits);
    }
    row->addStretch();
    words->addLayout(row);
    if (parts.gauge) words->addWidget(parts.gauge);
    words->addStretch();
    auto* inside = new QHBoxLayout(parts.frame);
    inside->setContentsMargins(kEdge, 1, kEdge, 1);
    inside->setSpacing(kBeside);
    inside->addLayout(words, 1);
    if (cell == Contact) inside->addWidget(map_ = new ContactMap(parts.frame));
    return parts;
}

void DriveStrip::place()
{
    for (const Parts& cell : cells_) grid_->removeWidget(cell.frame);
    for (int cell = 0; cell < kCells; ++cell) {
        const int inRow = rows_ == 1 ? kCells : kCells / 2;
        grid_->addWidget(cells_[static_cast<std::size_t>(cell)].frame, cell / inRow, cell % inRow);
        grid_->setColumnStretch(cell, cell < inRow ? 1 : 0);
    }
}

void DriveStrip::setRows(int rows)
{
    if (rows == rows_) return;
    rows_ = rows;
    place();
    updateGeometry();
}

int DriveStrip::cellWidth(Cell cell) const
{
    const int map = cell == Contact ? kBeside + map_->sizeHint().width() : 0;
    return words_.at(cell) + map + 2 * kEdge;
}

int DriveStrip::widthOfOneRow() const
{
    int width = 2 * kFrame + 2 + (kCells - 1) * grid_->horizontalSpacing();
    for (int cell = 0; cell < kCells; ++cell) width += cellWidth(static_cast<Cell>(cell));
    return width;
}

int DriveStrip::limitsWidth() const
{
    const int value = widestOf(sizedBold(kValueSize), valuesOf(Pitch));
    const int limits = widestOf(sizedBold(kCaptionSize), {DriveText::limits({1.5, 1.5})});
    const int wider = value + kBeside + limits + 2 * kEdge;
    return std::max(0, wider - cellWidth(Pitch)) + std::max(0, wider - cellWidth(Roll));
}

void DriveStrip::resizeToFont()
{
    for (int cell = 0; cell < kCells; ++cell) {
        const auto i = static_cast<std::size_t>(cell);
        const Parts& parts = cells_[i];
        const int words = words_[i] =
            std::max(widestOf(sizedBold(kCaptionSize), captionsOf(static_cast<Cell>(cell))),
                     widestOf(sizedBold(kValueSize), valuesOf(static_cast<Cell>(cell))));
        parts.caption->setMinimumWidth(words);  // keeps its width for every text
        parts.value->setMinimumHeight(QFontMetrics(sizedBold(kValueSize)).height());
        parts.caption->setMinimumHeight(QFontMetrics(sizedBold(kCaptionSize)).height());
        const Fill fill = fillOf(level(static_cast<Cell>(cell)));
        if (parts.gauge) parts.gauge->setInk(fill.text);
    }
    map_->setFill(fillOf(level(Contact)));
    limits_ = limitsWidth();
    showLimits();
}

void DriveStrip::showLimits()
{
    const bool fits = rows_ == 2 || width() >= widthOfOneRow() + limits_;
    for (const Parts& parts : cells_)
        if (parts.limits) parts.limits->setVisible(fits);
}

QSize DriveStrip::minimumSizeHint() const
{
    const QSize hint = QFrame::minimumSizeHint();
    return rows_ == 1 ? QSize(widthOfOneRow(), hint.height()) : hint;
}

void DriveStrip::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::StyleChange) resizeToFont();
}

void DriveStrip::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    showLimits();
}

void DriveStrip::setViewState(const DriveViewState& viewState)
{
    viewState_ = viewState;
    showAngle(Pitch, viewState.pitch);
    showAngle(Roll, viewState.roll);
    showContact(viewState.contact);
    showDistances(viewState);
}

void DriveStrip::showAngle(Cell cell, const std::optional<DriveViewState::Angle>& angle)
{
    const Parts& parts = cells_[cell];
    const AttitudeLevel level = angle ? angle->level : AttitudeLevel::Level;
    parts.caption->setText(withMark(nameOf(cell), DriveText::level(level)));
    parts.value->setText(angle ? format::degrees(angle->angle) : QString(format::kNothing));
    parts.limits->setText(angle ? DriveText::limits(angle->limits) : QString());
    const QString tip = angle ? tr("STEEP at %1, DANGER at %2, tips over at %3")
                                    .arg(format::degrees(angle->limits.amber, 0).remove(u'+'),
                                         format::degrees(angle->limits.red, 0).remove(u'+'),
                                         format::degrees(angle->tips, 0))
                              : tr("not known");
    setTip(*parts.value, tip);
    parts.value->setAccessibleDescription(withMark(DriveText::level(level), tip));
    parts.gauge->setAngle(angle);
    setLevel(*parts.frame, levelName(level));
    parts.gauge->setInk(fillOf(levelName(level)).text);
}

void DriveStrip::showContact(const std::optional<FlipperContacts>& contact)
{
    const Parts& parts = cells_[Contact];
    const bool touches = contact && contact->touches();
    parts.caption->setText(touches ? tr("● CONTACT") + QLatin1Char(' ') + DriveText::force(*contact)
                                   : nameOf(Contact));
    parts.value->setText(contact ? DriveText::contacts(*contact) : QString(format::kNothing));
    map_->setContacts(contact);
    const QString level = touches ? QStringLiteral("contact") : QString();
    if (level == this->level(Contact)) return;
    setLevel(*parts.frame, level);
    map_->setFill(fillOf(level));
}

void DriveStrip::showDistances(const DriveViewState& viewState)
{
    const auto show = [&](Cell cell, const std::optional<double>& value, const QString& text) {
        QLabel& label = *cells_[cell].value;
        label.setText(value ? text : QString(format::kNothing));
    };
    show(Speed, viewState.speed, DriveText::speed(viewState.speed.value_or(0.0)));
    show(Way, viewState.way, format::number(viewState.way.value_or(0.0), 2) + " m");
    show(FeltTo, viewState.feltTo, format::signedNumber(viewState.feltTo.value_or(0.0), 2) + " m");
    const Parts& felt = cells_[FeltTo];
    felt.caption->setText(
        withMark(nameOf(FeltTo), viewState.feltEnds ? QStringLiteral("!") : QString()));
}

QString DriveStrip::text(Cell cell) const
{
    return cells_.at(cell).value->text();
}

QString DriveStrip::caption(Cell cell) const
{
    return cells_.at(cell).caption->text();
}

QString DriveStrip::level(Cell cell) const
{
    return cells_.at(cell).frame->property("level").toString();
}

}  // namespace terratact
