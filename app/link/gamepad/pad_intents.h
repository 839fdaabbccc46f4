#pragma once

#include <array>
#include <cstdint>

#include "app/link/gamepad/pad_mapping.h"

namespace terratact {

/// What the operator wants by a gamepad at one instant. The default is nothing, as after letting go of everything.
struct PadIntents {
    double speed = 0.0;  ///< [m/s] forward positive; 0 without the dead-man control
    bool feelForward = false, approve = false;  ///< are held
    bool explore = false, refuse = false, raiseLimit = false,
         lowerLimit = false;     ///< pressed since the poll before
    bool stop = false;           ///< pressed since the poll before, at any time
    bool stickWasFirst = false;  ///< the dead-man control was taken with the stick deflected
    bool operator==(const PadIntents&) const = default;
};

/// Derives the operator's intents from a gamepad. It has no clock and moves nothing.
/// A control that is on when the gamepad is connected, or may act again, is ignored until it is released. The same
/// holds when the mapping changes or release() is called. A lost gamepad has no intents. A drive needs the dead-man
/// control first, then the stick from its centre, so a drifting stick moves nothing. STOP counts whether or not the
/// gamepad may act.
class PadFollower {
public:
    /// mayAct: the operator is at the console's window. Otherwise only STOP counts.
    PadIntents poll(const GamepadState& state, const PadSettings& settings, bool mayAct);

    /// Return the state of an action's control at the last poll: it is on; it is on and counts.
    bool isTouched(PadAction action) const
    {
        return controls_.at(static_cast<std::size_t>(action)).on;
    }
    bool counts(PadAction action) const
    {
        return isTouched(action) && controls_.at(static_cast<std::size_t>(action)).counts;
    }

    /// Everything but STOP must be released before it counts again.
    void release();

private:
    /// A control counts only after it was seen off.
    struct Control {
        bool on = false, counts = false;
    };
    /// Returns true while the action's control counts and is on. pressed: it was not on before.
    bool isHeld(PadAction action, bool& pressed);
    void read(const GamepadState& state, const PadMapping& mapping);
    double drive(const GamepadState& state, const PadSettings& settings, bool& stickWasFirst);

    std::uint32_t connection_ = 0;
    PadMapping mapping_;
    bool acts_ = false;     ///< mayAct of the poll before
    bool centred_ = false;  ///< the stick was centred since the dead-man control is held
    std::array<Control, kPadActions> controls_{};
    std::array<bool, kPadActions> wasHeld_{};
};

}  // namespace terratact
