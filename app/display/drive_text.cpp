#include "app/display/drive_text.h"

#include <QStringList>
#include <array>

#include "app/display/format.h"
#include "app/display/place_text.h"

namespace terratact {
namespace {

constexpr std::array kEachFlipper{Flipper::FrontLeft, Flipper::FrontRight, Flipper::RearLeft,
                                  Flipper::RearRight};

bool isRear(Flipper flipper)
{
    return flipper == Flipper::RearLeft || flipper == Flipper::RearRight;
}

Side sideOf(Flipper flipper)
{
    return flipper == Flipper::FrontLeft || flipper == Flipper::RearLeft ? Side::Left : Side::Right;
}

/// Returns the contacts to name: without known sides, the left one stands for both.
QList<ElementContact> named(const FlipperContacts& state)
{
    QList<ElementContact> found;
    for (const Flipper flipper : kEachFlipper) {
        if (!state.sidesKnown && flipper == Flipper::FrontRight) continue;
        if (const auto contact = state.strongest(flipper)) found << *contact;
    }
    return found;
}

}  // namespace

QString DriveText::level(AttitudeLevel level)
{
    switch (level) {
    case AttitudeLevel::Level: return {};
    case AttitudeLevel::Amber: return tr("! STEEP");
    case AttitudeLevel::Red: return tr("✘ DANGER");
    }
    return {};
}

QString DriveText::limits(const AttitudeLimits& limits)
{
    return QStringLiteral("! %1 ✘ %2")
        .arg(format::plainAngle(limits.amber, 0), format::plainAngle(limits.red, 0));
}

QString DriveText::contacts(const FlipperContacts& state)
{
    QStringList front, rear;
    for (const ElementContact& contact : named(state)) {
        const QString side = state.sidesKnown || isRear(contact.flipper)
                               ? sideLetter(sideOf(contact.flipper))
                               : QString();
        (isRear(contact.flipper) ? rear : front) << side + QString::number(contact.element + 1);
    }
    if (front.isEmpty() && rear.isEmpty()) return tr("none");
    QString ahead = front.join(QLatin1Char(' '));
    if (rear.isEmpty()) return ahead;
    return (ahead + QLatin1Char(' ') + tr("rear %1").arg(rear.join(QLatin1Char(' ')))).trimmed();
}

QString DriveText::contactsSpoken(const FlipperContacts& state)
{
    QStringList texts;
    for (const ElementContact& contact : named(state)) {
        const QString element = QString::number(contact.element + 1);
        const QString force = format::number(contact.force, 1);
        if (isRear(contact.flipper))
            texts << tr("rear %1 %2: %3 N").arg(sideWord(sideOf(contact.flipper)), element, force);
        else if (state.sidesKnown)
            texts << tr("%1 %2: %3 N").arg(sideWord(sideOf(contact.flipper)), element, force);
        else
            texts << tr("front %1: %2 N").arg(element, force);
    }
    return texts.isEmpty() ? tr("none") : texts.join(QStringLiteral("; "));
}

QString DriveText::force(const FlipperContacts& state)
{
    const auto contact = state.strongest();
    return contact ? format::number(contact->force, 0) + QStringLiteral(" N") : QString();
}

QString DriveText::speed(double metresPerSecond)
{
    return format::signedNumber(metresPerSecond, 2) + QStringLiteral(" m/s");
}

}  // namespace terratact
