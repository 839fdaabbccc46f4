#include "core/atem/panel.h"

#include "core/base/named.h"
#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

constexpr auto kPanelContactNames = namesOf<PanelContact>("atem", "approve", "refuse", "stop");

constexpr double kLampTime = 0.3;    ///< [s] test of each lamp
constexpr double kBuzzerTime = 0.1;  ///< [s]

/// Returns the state of a contact at its first reading.
ContactState firstContact(bool closed, double now)
{
    ContactState contact;
    contact.closed = closed;
    contact.since = now;
    return contact;
}

bool undisturbed(const ContactState& contact, double now, const PanelLimits& limits)
{
    return now - contact.since >= limits.settle;
}

ContactState looked(ContactState contact, bool closed, bool disturbed, double now,
                    const PanelLimits& limits)
{
    if (disturbed || closed != contact.closed) contact.since = now;
    contact.closed = closed;
    contact.trusted = closed && undisturbed(contact, now, limits);
    return contact;
}

ButtonPhase nextPhase(const ContactState& button, double now, const PanelLimits& limits)
{
    if (!button.closed && undisturbed(button, now, limits)) return ButtonPhase::Released;
    switch (button.phase) {
    case ButtonPhase::Starting:
        return button.trusted ? ButtonPhase::HeldAtStart : ButtonPhase::Starting;
    case ButtonPhase::Released:
        return button.trusted ? ButtonPhase::Pressed : ButtonPhase::Released;
    case ButtonPhase::Pressed:
        return now - button.pressedAt > limits.stuck ? ButtonPhase::Stuck : ButtonPhase::Pressed;
    case ButtonPhase::HeldAtStart:
    case ButtonPhase::Stuck: return button.phase;
    }
    throw std::invalid_argument("nextPanel: a button's phase is none");
}

/// Updates the button's phase. Returns true if it was pressed in this tick.
bool pressedAnew(ContactState& button, double now, const PanelLimits& limits)
{
    const ButtonPhase before = button.phase;
    button.phase = nextPhase(button, now, limits);
    const bool anew = before == ButtonPhase::Released && button.phase == ButtonPhase::Pressed;
    if (anew) button.pressedAt = now;
    return anew;
}

}  // namespace

std::string_view name(PanelContact contact)
{
    return nameIn(kPanelContactNames, contact);
}

bool PanelState::held(PanelContact button) const
{
    return contacts[button].trusted && contacts[button].phase == ButtonPhase::Pressed;
}

PanelState nextPanel(const PanelState& state, const PanelInput& in, const PanelLimits& limits)
{
    if (!std::isfinite(in.now)) throw std::invalid_argument("nextPanel: the time is not finite");
    PanelState next;
    next.time = in.now;
    if (!in.closed) return next;
    next.present = true;
    for (const PanelContact c : kAllPanelContacts)
        next.contacts[c] = state.present ? looked(state.contacts[c], (*in.closed)[c],
                                                  in.disturbed[c], in.now, limits)
                                         : firstContact((*in.closed)[c], in.now);
    for (const PanelContact c : kPanelButtons)
        next.pressed[c] = pressedAnew(next.contacts[c], in.now, limits);
    next.stop = !next.contacts[PanelContact::Stop].trusted;
    return next;
}

Message buttonTrouble(PanelContact button, ButtonPhase phase)
{
    switch (phase) {
    case ButtonPhase::Starting:
    case ButtonPhase::Released:
    case ButtonPhase::Pressed: return {};
    case ButtonPhase::HeldAtStart:
        return {
            TR_NOOP(
                "core",
                "the panel's button %1 was held when the panel came up. It counts as not pressed "
                "until it is released. If it is not held, its contact sticks or its wires touch"),
            name(button)};
    case ButtonPhase::Stuck:
        return {
            TR_NOOP(
                "core",
                "the panel's button %1 has been held for too long. It counts as not pressed until "
                "it is released. If it is not held, its contact sticks or its wires touch"),
            name(button)};
    }
    throw std::invalid_argument("buttonTrouble: no such phase");
}

std::array<bool, kPanelOutputs> outputsOf(const LampState& lamps)
{
    return {lamps.link, lamps.armed, lamps.probing, lamps.buzzer};
}

std::optional<LampState> lampTest(double elapsed)
{
    const double buzzerFrom = 3.0 * kLampTime, darkFrom = buzzerFrom + kBuzzerTime;
    if (!(elapsed >= 0.0 && elapsed < darkFrom + kLampTime)) return std::nullopt;
    return LampState{.link = elapsed < kLampTime,
                     .armed = elapsed >= kLampTime && elapsed < 2.0 * kLampTime,
                     .probing = elapsed >= 2.0 * kLampTime && elapsed < buzzerFrom,
                     .buzzer = elapsed >= buzzerFrom && elapsed < darkFrom};
}

}  // namespace terratact
