#include "app/link/gamepad/pad_intents.h"

#include <utility>

namespace terratact {

PadIntents PadFollower::poll(const GamepadState& state, const PadSettings& settings, bool mayAct)
{
    PadIntents intents;
    const bool isOther = state.connection != connection_ || settings.mapping != mapping_;
    connection_ = state.connection;
    mapping_ = settings.mapping;
    if (isOther) {
        controls_ = {};
        wasHeld_ = {};
        centred_ = false;
    }
    if (std::exchange(acts_, mayAct) != mayAct) release();
    if (!state.isConnected()) return intents;

    read(state, settings.mapping);
    bool pressed = false, pressedSecond = false, began = false;
    isHeld(PadAction::Stop, pressed);
    isHeld(PadAction::SecondStop, pressedSecond);
    intents.stop = pressed || pressedSecond;
    if (!mayAct) return intents;

    isHeld(PadAction::Explore, intents.explore);
    isHeld(PadAction::Refuse, intents.refuse);
    isHeld(PadAction::RaiseLimit, intents.raiseLimit);
    isHeld(PadAction::LowerLimit, intents.lowerLimit);
    intents.approve = isHeld(PadAction::Approve, began);
    intents.feelForward = isHeld(PadAction::FeelForward, began);
    intents.speed = drive(state, settings, intents.stickWasFirst);
    return intents;
}

void PadFollower::release()
{
    for (std::size_t i = 0; i < kPadActions; ++i) {
        const auto action = static_cast<PadAction>(i);
        if (action == PadAction::Stop || action == PadAction::SecondStop) continue;
        controls_[i].counts = false;
        wasHeld_[i] = false;
    }
    centred_ = false;
}

void PadFollower::read(const GamepadState& state, const PadMapping& mapping)
{
    for (std::size_t i = 0; i < kPadActions; ++i) {
        Control& control = controls_[i];
        const auto& mapped = mapping[static_cast<PadAction>(i)];
        control.on = mapped && isOn(*mapped, state, control.on);
        control.counts = control.counts || !control.on;
    }
}

bool PadFollower::isHeld(PadAction action, bool& pressed)
{
    const auto i = static_cast<std::size_t>(action);
    const bool held = controls_[i].counts && controls_[i].on;
    pressed = held && !wasHeld_[i];
    wasHeld_[i] = held;
    return held;
}

double PadFollower::drive(const GamepadState& state, const PadSettings& settings,
                          bool& stickWasFirst)
{
    bool began = false;
    const bool enabled = isHeld(PadAction::DeadMan, began);
    const auto& control = settings.mapping[PadAction::Drive];
    const auto* stick = control ? std::get_if<PadStick>(&*control) : nullptr;
    if (!enabled || !stick) {
        centred_ = false;
        return 0.0;
    }
    const double speed = speedOf(*stick, state, settings);
    stickWasFirst = began && speed != 0.0;
    centred_ = centred_ || speed == 0.0;
    return centred_ ? speed : 0.0;
}

}  // namespace terratact
