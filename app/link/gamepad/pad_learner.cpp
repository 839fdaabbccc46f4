#include "app/link/gamepad/pad_learner.h"

#include <cmath>

namespace terratact {
namespace {

constexpr double kPushed = 0.7;  // of a stick's way

bool isTurnedOn(const PadControl& control, const GamepadState& before, const GamepadState& now)
{
    if (const auto* stick = std::get_if<PadStick>(&control))
        return now[stick->axis] * stick->forward > kPushed
            && !(before[stick->axis] * stick->forward > kPushed);
    return isOn(control, now, false) && !isOn(control, before, false);
}

}  // namespace

std::optional<PadControl> PadLearner::poll(const GamepadState& state)
{
    if (!before_ || before_->connection != state.connection) {
        before_ = state;
        return std::nullopt;
    }
    const GamepadState before = *before_;
    before_ = state;
    for (const PadControl& control : allPadControls())
        if (suits(action_, control) && isTurnedOn(control, before, state)) return control;
    return std::nullopt;
}

}  // namespace terratact
