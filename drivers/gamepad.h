#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace terratact {

/// Axes of a gamepad in the standard layout. Sticks: −1 … 1, right and down positive. Triggers: 0 … 1.
enum class PadAxis : std::uint8_t { LeftX, LeftY, RightX, RightY, LeftTrigger, RightTrigger };
inline constexpr std::size_t kPadAxes = 6;

/// Buttons of a gamepad in the standard layout. A, B, X, Y are the lower, right, left and upper one.
enum class PadButton : std::uint8_t {
    A,
    B,
    X,
    Y,
    Back,
    Guide,
    Start,
    LeftStick,
    RightStick,
    LeftShoulder,
    RightShoulder,
    Up,
    Down,
    Left,
    Right,
};
inline constexpr std::size_t kPadButtons = 15;

/// Return SDL's names, which files use: "lefty", "righttrigger"; "a", "dpup".
std::string_view name(PadAxis axis);
std::string_view name(PadButton button);

/// What a gamepad reports. The default is no gamepad.
struct GamepadState {
    std::uint32_t connection = 0;  ///< number of the connection, from 1; 0: no gamepad
    std::string name{};            ///< as the device reports it
    bool radio = false;            ///< connected by Bluetooth: its silence is noticed late
    std::array<double, kPadAxes> axes{};
    std::array<bool, kPadButtons> buttons{};
    Message trouble{};  ///< why there is none, or why a connected device is not used

    bool isConnected() const { return connection != 0; }
    double operator[](PadAxis axis) const { return axes.at(static_cast<std::size_t>(axis)); }
    bool operator[](PadButton button) const { return buttons.at(static_cast<std::size_t>(button)); }
    double& operator[](PadAxis axis) { return axes.at(static_cast<std::size_t>(axis)); }
    bool& operator[](PadButton button) { return buttons.at(static_cast<std::size_t>(button)); }
};

/// The gamepads of this computer, one of which is read: the first, until it is lost. One thread at a time.
class Gamepad {
public:
    virtual ~Gamepad() = default;
    /// Returns the newest state after `pause`. A lost gamepad is one without any axis or button.
    virtual GamepadState poll(std::chrono::milliseconds pause) = 0;

protected:
    Gamepad() = default;
    Gamepad(const Gamepad&) = default;
    Gamepad& operator=(const Gamepad&) = default;
};

}  // namespace terratact
