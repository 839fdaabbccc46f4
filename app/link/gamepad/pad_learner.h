#pragma once

#include <optional>

#include "app/link/gamepad/pad_mapping.h"

namespace terratact {

/// Finds the control that the operator moves to assign it to an action. A control that is on when it begins does not
/// count until it was off. A stick counts beyond 0.7 of its way, and its direction is forward.
class PadLearner {
public:
    explicit PadLearner(PadAction action) : action_(action) {}

    PadAction action() const { return action_; }

    /// Returns the control that suits the action and was turned on since the poll before; empty: none yet.
    std::optional<PadControl> poll(const GamepadState& state);

private:
    PadAction action_;
    std::optional<GamepadState> before_;
};

}  // namespace terratact
