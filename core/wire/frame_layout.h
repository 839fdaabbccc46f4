#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace terratact {

/// Every frame of resources/dbc/terratact.dbc, which describes each of them.
enum class FrameKind : std::uint8_t {
    Stop,
    ReleaseStop,
    Arm,
    Halt,
    Drive,
    BeginAtem,
    AbortAtem,
    PressFlippers,
    HoldFlippers,
    ProbeBin,
    Advance,
    ConsoleHeartbeat,
    Odometry,
    RobotStatus,
    RobotHeartbeat,
    Attitude,
    FrontAngles,
    RearAngles,
    FrontCurrents,
    RearCurrents,
    LeftForces1To3,
    LeftForces4To6,
    RightForces1To3,
    RightForces4To6,
    ArmResult,
    RearLeftForces1To3,
    RearLeftForces4To6,
    RearRightForces1To3,
    RearRightForces4To6,
    Differential,
};

inline constexpr std::size_t kFrameKinds = 30;
inline constexpr std::size_t kMaxSignals = 7;  ///< signals of one frame

/// A signal behind the E2E header: `length` bits from bit `start` on, little-endian. Bit 0 is the
/// lowest bit of byte 0. Its value is raw · scale, in SI units. Forces travel as voltages, which
/// elementForces() converts (core/wire/telemetry.h).
struct SignalLayout {
    std::string_view name;
    int start = 0;
    int length = 0;
    bool isSigned = false;
    double scale = 1.0;
    double least = 0.0, most = 0.0;  ///< both ends belong to the range
    std::string_view unit;
};

/// A frame as in the DBC file. It always has a standard identifier and eight bytes.
struct FrameLayout {
    std::string_view name;
    std::uint32_t id = 0;
    std::uint16_t dataId = 0;  ///< data ID of E2E Profile 5
    bool fromConsole = false;
    double period = 0.0;                    ///< time between frames [s]; 0: event-driven
    std::span<const SignalLayout> payload;  ///< its signals; `signals` is a macro of Qt
};

/// Returns the layout of a frame. Throws std::invalid_argument for an invalid FrameKind.
const FrameLayout& layoutOf(FrameKind kind);

/// Returns the layouts of all frames, in the order of FrameKind.
std::span<const FrameLayout, kFrameKinds> frameLayouts();

/// Returns the frame with this standard identifier.
std::optional<FrameKind> kindOfId(std::uint32_t id);

/// Return the raw ends of a signal's range: least and most, divided by the scale.
std::int64_t leastRaw(const SignalLayout& signal);
std::int64_t mostRaw(const SignalLayout& signal);

}  // namespace terratact
