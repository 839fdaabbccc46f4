#include "widgets/control/drive_strip.h"

#include <QEvent>
#include <QStringList>

#include "app/display/drive_text.h"
#include "app/display/format.h"
#include "app/display/units.h"
#include "core/base/degree.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr int kFrame = 2;  // [px] of the strip around the cells

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
    case DriveStrip::Speed: return DriveStrip::tr("Along the tracks, over the last 0.3 s");
    case DriveStrip::Way: return DriveStrip::tr("Distance rolled since the last estimate");
    case DriveStrip::FeltTo:
        return DriveStrip::tr(
            "The ground is felt up to here, forward from the IMU, on both sides. \"!\": the tracks "
            "are about to leave felt ground. \"none\": nothing ahead is felt");
    default: return {};
    }
}

QString withMark(const QString& name, const QString& mark)
{
    return mark.isEmpty() ? name : name + QLatin1Char(' ') + mark;
}

/// Returns the caption of an angle in a narrow strip. It contains the unit of radians, which the value then lacks.
QString shortAngleName(DriveStrip::Cell cell)
{
    const bool isRadian = units().angle == AngleUnit::Radian;
    return isRadian ? nameOf(cell) + QStringLiteral(" rad") : nameOf(cell);
}

/// Returns an angle for a narrow strip, without the unit of radians.
QString shortAngle(double radians)
{
    return format::angle(radians).section(QLatin1Char(' '), 0, 0);
}

/// Returns the mark of a level without its word.
QString markOf(AttitudeLevel level)
{
    return DriveText::level(level).section(QLatin1Char(' '), 0, 0);
}

QString contactCaption(const FlipperContacts& contact, const QString& word)
{
    return word + QLatin1Char(' ') + DriveText::force(contact);
}

/// Returns the widest texts of a cell.
DriveCell::Widest widestOf(DriveStrip::Cell cell)
{
    const QString name = nameOf(cell);
    const auto levels = [](const QString& word, QString (*text)(AttitudeLevel)) {
        return QStringList{withMark(word, text(AttitudeLevel::Amber)),
                           withMark(word, text(AttitudeLevel::Red))};
    };
    const QString ended = withMark(name, QStringLiteral("!"));
    switch (cell) {
    case DriveStrip::Pitch:
    case DriveStrip::Roll:
        return {levels(name, DriveText::level),
                levels(shortAngleName(cell), markOf),
                {format::angle(-88.8 * kDegree)},
                DriveText::limits({1.5, 1.5}),
                {shortAngle(-88.8 * kDegree)}};
    case DriveStrip::Contact: {
        const QStringList words{name, DriveStrip::tr("● CONTACT") + QStringLiteral(" 20 N")};
        return {words, words, {DriveText::contacts({}), QStringLiteral("L5 R5")}, {}};
    }
    case DriveStrip::Speed: return {{name}, {name}, {DriveText::speed(-0.88)}, {}};
    case DriveStrip::Way: return {{name}, {name}, {format::length(88.88, 2)}, {}};
    case DriveStrip::FeltTo:
        return {{ended}, {ended}, {format::signedLength(8.88, 2), DriveStrip::tr("none")}, {}};
    case DriveStrip::kCells: break;
    }
    return {};
}

DriveCell::Kind kindOf(DriveStrip::Cell cell)
{
    if (cell == DriveStrip::Contact) return DriveCell::Kind::Contact;
    return cell == DriveStrip::Pitch || cell == DriveStrip::Roll ? DriveCell::Kind::Angle
                                                                 : DriveCell::Kind::Number;
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

}  // namespace

DriveStrip::DriveStrip(QWidget* parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("driveStrip"));
    setProperty("card", true);
    setAccessibleName(tr("Driving"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    for (int i = 0; i < kCells; ++i) {
        const auto cell = static_cast<Cell>(i);
        auto* const made = new DriveCell(kindOf(cell), widestOf(cell), this);
        made->setAccessibleName(nameOf(cell));
        setTip(*made, tipOf(cell));
        cells_[static_cast<std::size_t>(i)] = made;
    }
    setViewState({});
}

int DriveStrip::widthFor(DriveDetail detail) const
{
    int width = 2 * kFrame;
    for (const DriveCell* cell : cells_) width += cell->widthFor(detail);
    return width;
}

QSize DriveStrip::minimumSizeHint() const
{
    return {widthFor(DriveDetail::Short), DriveCell::heightOfAll() + 2 * kFrame};
}

/// Shows as much as fits, and shares the spare width equally.
void DriveStrip::place()
{
    detail_ = DriveDetail::Short;
    for (const DriveDetail more : {DriveDetail::Words, DriveDetail::Limits})
        if (width() >= widthFor(more)) detail_ = more;
    const int spare = width() - widthFor(detail_);
    int left = kFrame;
    for (int i = 0; i < kCells; ++i) {
        DriveCell& cell = *cells_[static_cast<std::size_t>(i)];
        cell.setDetail(detail_);
        const int share = spare * (i + 1) / kCells - spare * i / kCells;
        const int wide = cell.widthFor(detail_) + share;
        cell.setGeometry(left, kFrame, wide, height() - 2 * kFrame);
        left += wide;
    }
}

void DriveStrip::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() != QEvent::StyleChange) return;
    updateGeometry();
    place();
}

void DriveStrip::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    place();
}

void DriveStrip::setViewState(const DriveViewState& viewState)
{
    viewState_ = viewState;
    const int before = widthFor(DriveDetail::Short);
    showAngle(Pitch, viewState.pitch);
    showAngle(Roll, viewState.roll);
    showContact(viewState.contact);
    showDistances(viewState);
    if (widthFor(DriveDetail::Short) == before) return;  // the rear elements need room
    updateGeometry();
    place();
}

void DriveStrip::show(Cell cell, const DriveCell::Content& content, const QString& description)
{
    DriveCell& shown = *cells_.at(cell);
    if (content == shown.content() && shown.accessibleDescription() == description) return;
    shown.setAccessibleDescription(description);
    shown.setContent(content);
}

void DriveStrip::showAngle(Cell cell, const std::optional<DriveViewState::Angle>& angle)
{
    const AttitudeLevel level = angle ? angle->level : AttitudeLevel::Level;
    const QString limits =
        angle ? tr("STEEP at %1, DANGER at %2, tips over at %3")
                    .arg(format::plainAngle(angle->limits.amber, 0),
                         format::plainAngle(angle->limits.red, 0), format::angle(angle->tips, 0))
              : tr("not known");
    const QString value = angle ? format::angle(angle->angle) : QString(format::kNothing);
    if (limits != tipOf(*cells_.at(cell))) setTip(*cells_.at(cell), limits);
    show(cell,
         {.caption = withMark(nameOf(cell), DriveText::level(level)),
          .shortCaption = withMark(shortAngleName(cell), markOf(level)),
          .value = value,
          .shortValue = angle ? shortAngle(angle->angle) : QString(),
          .limits = angle ? DriveText::limits(angle->limits) : QString(),
          .level = levelName(level),
          .angle = angle},
         value + QStringLiteral("; ") + withMark(DriveText::level(level), limits).trimmed());
}

void DriveStrip::showContact(const std::optional<FlipperContacts>& contact)
{
    const bool touches = contact && contact->touches();
    const QString caption = touches ? contactCaption(*contact, tr("● CONTACT")) : nameOf(Contact);
    show(Contact,
         {.caption = caption,
          .shortCaption = caption,
          .value = contact ? DriveText::contacts(*contact) : QString(format::kNothing),
          .level = touches ? QStringLiteral("contact") : QString(),
          .contacts = contact},
         contact ? DriveText::contactsSpoken(*contact) : tr("not known"));
}

void DriveStrip::showDistances(const DriveViewState& viewState)
{
    const auto show = [&](Cell cell, const std::optional<double>& value, const QString& text,
                          const QString& mark = {},
                          const QString& nothing = QString(format::kNothing)) {
        const QString caption = withMark(nameOf(cell), mark);
        const QString shown = value ? text : nothing;
        this->show(cell, {.caption = caption, .shortCaption = caption, .value = shown},
                   withMark(shown, mark));
    };
    show(Speed, viewState.speed, DriveText::speed(viewState.speed.value_or(0.0)));
    show(Way, viewState.way, format::length(viewState.way.value_or(0.0), 2));
    show(FeltTo, viewState.feltTo, format::signedLength(viewState.feltTo.value_or(0.0), 2),
         viewState.feltEnds ? QStringLiteral("!") : QString(),
         viewState.feltEnds ? tr("none") : QString(format::kNothing));
}

QString DriveStrip::text(Cell cell) const
{
    return cells_.at(cell)->content().value;
}

QString DriveStrip::caption(Cell cell) const
{
    return cells_.at(cell)->content().caption;
}

QString DriveStrip::level(Cell cell) const
{
    return cells_.at(cell)->content().level;
}

}  // namespace terratact
