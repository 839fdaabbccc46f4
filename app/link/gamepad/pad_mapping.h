#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/atem/command_gate.h"
#include "drivers/gamepad.h"

namespace terratact {

/// What the operator does with a gamepad. DeadMan, Approve and FeelForward act while they are held,
/// and Drive by the way of its stick. The others act when they are pressed.
enum class PadAction : std::uint8_t {
    Stop,
    SecondStop,  ///< another button of STOP
    DeadMan,     ///< the enabling control of Drive
    Drive,
    FeelForward,
    Explore,
    Approve,
    Refuse,
    RaiseLimit,
    LowerLimit,
};
inline constexpr std::size_t kPadActions = 10;

/// Returns the name of an action in files: "stop", "dead-man".
std::string_view name(PadAction action);

/// A stick's axis. forward: the sign of its forward direction, −1 or +1.
struct PadStick {
    PadAxis axis = PadAxis::LeftY;
    int forward = -1;
    bool operator==(const PadStick&) const = default;
};

/// A control of a gamepad: a button, a trigger (PadAxis::LeftTrigger or RightTrigger), or a stick's axis.
using PadControl = std::variant<PadButton, PadAxis, PadStick>;

/// Returns every control: buttons, triggers, and the sticks' axes in both directions.
std::vector<PadControl> allPadControls();

/// Returns the name of a control in files: SDL's, and for a stick the sign of forward: "lefty-".
std::string textOf(const PadControl& control);

/// Returns true if both are the same part of the gamepad, whatever the sign.
bool isSamePart(const PadControl& a, const PadControl& b);

/// Returns true if the control suits the action: Drive needs a stick's axis, every other a button or a trigger.
bool suits(PadAction action, const PadControl& control);

/// Controls of the actions. No two actions share a control, and Stop always has one.
class PadMapping {
public:
    PadMapping();  ///< the default, for SDL's standard layout

    /// Returns the control of an action; empty: none.
    const std::optional<PadControl>& operator[](PadAction action) const
    {
        return controls_.at(static_cast<std::size_t>(action));
    }
    /// Returns the action of a control; empty: none.
    std::optional<PadAction> actionOf(const PadControl& control) const;

    /// Gives a control to an action and takes it from any other. Does nothing and returns false for
    /// a control that does not suit the action. The same holds for a button of STOP, which no other
    /// action may take.
    bool assign(PadAction action, const PadControl& control);

    /// Returns "stop:rightshoulder second-stop:back …"; an action without a control is left out.
    std::string text() const;
    /// Reads text(); empty: an unknown word, a control that does not suit, a second use, or no control for Stop.
    static std::optional<PadMapping> parse(std::string_view text);

    bool operator==(const PadMapping&) const = default;

private:
    std::optional<PadControl>& at(PadAction action)
    {
        return controls_.at(static_cast<std::size_t>(action));
    }
    std::array<std::optional<PadControl>, kPadActions> controls_{};
};

/// All that decides how a gamepad drives.
struct PadSettings {
    PadMapping mapping{};
    double deadZone = 0.15;   ///< share of the stick's way around its centre without effect
    double speedLimit = 0.2;  ///< [m/s] at full deflection
    bool operator==(const PadSettings&) const = default;
};
inline constexpr double kSmallestDeadZone = 0.05, kLargestDeadZone = 0.6;
inline constexpr double kSlowestPad = 0.02, kFastestPad = GateLimits{}.speed;  ///< [m/s]

/// Returns true if a button is pressed, or a trigger is pulled by more than half. was: the answer to the poll before; a
/// pulled trigger counts as released below 0.4, so that it does not flutter. A stick's axis is never on.
bool isOn(const PadControl& control, const GamepadState& state, bool was);

/// Returns the speed [m/s] of the stick: 0 within the dead zone, from there linearly to the limit at full deflection.
/// It is a multiple of kPadSpeedStep, and at least one step outside the dead zone. NaN counts as centred.
double speedOf(const PadStick& stick, const GamepadState& state, const PadSettings& settings);
inline constexpr double kPadSpeedStep = 0.005;  ///< [m/s]

}  // namespace terratact
