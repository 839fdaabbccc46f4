#include "core/wire/frame_layout.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

constexpr double kHalfTurn = 3.1416;  // [rad] half a turn, rounded to its scale
constexpr double kHeld = 3.14;        // [rad] range of a held flipper, in 12 bits
constexpr SignalLayout kEpoch{"Epoch", 24, 8, false, 1.0, 0.0, 255.0, ""};
constexpr SignalLayout kToken{"Token", 24, 16, false, 1.0, 0.0, 65535.0, ""};
constexpr SignalLayout kChallenge{"Challenge", 48, 16, false, 1.0, 0.0, 65535.0, ""};

constexpr SignalLayout flag(std::string_view name, int start)
{
    return {name, start, 1, false, 1.0, 0.0, 1.0, ""};
}

constexpr SignalLayout angle(std::string_view name, int start, double most = kHalfTurn)
{
    return {name, start, 16, true, 1e-4, -most, most, "rad"};
}

constexpr SignalLayout current(std::string_view name, int start)
{
    return {name, start, 16, true, 1e-3, -20.0, 20.0, "A"};
}

constexpr SignalLayout voltage(std::string_view name, int start)
{
    return {name, start, 13, false, 6.25e-4, 0.0, 5.119375, "V"};
}

constexpr SignalLayout kEpochAlone[]{kEpoch};
constexpr SignalLayout kTokenAlone[]{kToken};
constexpr SignalLayout kAnswer[]{kToken, kChallenge};
constexpr SignalLayout kFresh[]{kEpoch, kChallenge};
constexpr SignalLayout kArm[]{kEpoch, flag("Armed", 32), kChallenge};
constexpr SignalLayout kDrive[]{
    kEpoch, {"Speed", 32, 16, true, 1e-4, -0.6, 0.6, "m/s"}, kChallenge};
constexpr SignalLayout kPress[]{
    kEpoch, {"Torque", 32, 16, false, 0.01, 0.01, 60.0, "N.m"}, kChallenge};
constexpr SignalLayout kHold[]{{"Front", 24, 12, true, 2e-3, -kHeld, kHeld, "rad"},
                               {"Rear", 36, 12, true, 2e-3, -kHeld, kHeld, "rad"},
                               kChallenge};
constexpr SignalLayout kProbe[]{kEpoch,
                                {"Bin", 32, 8, false, 1.0, 0.0, 10.0, ""},
                                {"Side", 40, 2, false, 1.0, 0.0, 2.0, ""},
                                kChallenge};
constexpr SignalLayout kAdvance[]{
    kEpoch, {"Distance", 32, 16, false, 1e-4, 0.001, 0.1, "m"}, kChallenge};
constexpr SignalLayout kOdometry[]{{"Travelled", 24, 24, true, 1e-3, -8388.607, 8388.607, "m"},
                                   {"Turned", 48, 15, true, 2e-4, -kHalfTurn, kHalfTurn, "rad"},
                                   flag("Measured", 63)};
constexpr SignalLayout kStatusSignals[]{{"Epoch", 24, 8, false, 1.0, 1.0, 255.0, ""},
                                        {"Activity", 32, 4, false, 1.0, 0.0, 5.0, ""},
                                        {"Refusal", 36, 4, false, 1.0, 0.0, 8.0, ""},
                                        flag("Armed", 40),
                                        flag("Exploring", 41),
                                        {"LastCommand", 48, 8, false, 1.0, 0.0, 26.0, ""},
                                        {"LastCounter", 56, 8, false, 1.0, 0.0, 255.0, ""}};
constexpr SignalLayout kAttitude[]{angle("Pitch", 24, 1.6), angle("Roll", 40),
                                   flag("Measured", 56)};
constexpr SignalLayout kAngles[]{angle("Left", 24), angle("Right", 40), flag("Measured", 56)};
constexpr SignalLayout kCurrents[]{current("Left", 24), current("Right", 40), flag("Measured", 56),
                                   flag("LeftMissing", 57), flag("RightMissing", 58)};
constexpr SignalLayout kForces1To3[]{voltage("Element1", 24), voltage("Element2", 37),
                                     voltage("Element3", 50), flag("Measured", 63)};
constexpr SignalLayout kForces4To6[]{voltage("Element4", 24), voltage("Element5", 37),
                                     voltage("Element6", 50), flag("Measured", 63)};
constexpr SignalLayout kArmResult[]{{"Bin", 24, 4, false, 1.0, 0.0, 10.0, ""},
                                    {"Height", 28, 16, true, 1e-4, -2.0, 2.0, "m"},
                                    {"Sd", 44, 13, false, 1e-4, 0.0, 0.5, "m"},
                                    flag("Measured", 57),
                                    {"Side", 58, 2, false, 1.0, 0.0, 2.0, ""}};
constexpr SignalLayout kDifferential[]{angle("Angle", 24), flag("Measured", 40)};

constexpr double kLine = 0.05;  // [s] between telemetry lines

// Layouts in the order of FrameKind.
constexpr std::array<FrameLayout, kFrameKinds> kLayouts{{
    {"Stop", 0x010, 0x5410, true, 0.0, {}},
    {"ReleaseStop", 0x011, 0x5411, true, 0.0, kFresh},
    {"Arm", 0x012, 0x5412, true, 0.0, kArm},
    {"Halt", 0x013, 0x5413, true, 0.0, kEpochAlone},
    {"Drive", 0x014, 0x5414, true, 0.02, kDrive},
    {"BeginAtem", 0x015, 0x5415, true, 0.0, kFresh},
    {"AbortAtem", 0x016, 0x5416, true, 0.0, kEpochAlone},
    {"PressFlippers", 0x017, 0x5417, true, 0.0, kPress},
    {"HoldFlippers", 0x018, 0x5418, true, 0.0, kHold},
    {"ProbeBin", 0x019, 0x5419, true, 0.0, kProbe},
    {"Advance", 0x01A, 0x541A, true, 0.0, kAdvance},
    {"ConsoleHeartbeat", 0x01B, 0x541B, true, 0.1, kTokenAlone},
    {"Odometry", 0x01F, 0x541F, false, kLine, kOdometry},
    {"RobotStatus", 0x020, 0x5420, false, kLine, kStatusSignals},
    {"RobotHeartbeat", 0x021, 0x5421, false, 0.0, kAnswer},
    {"Attitude", 0x022, 0x5422, false, kLine, kAttitude},
    {"FrontAngles", 0x023, 0x5423, false, kLine, kAngles},
    {"RearAngles", 0x024, 0x5424, false, kLine, kAngles},
    {"FrontCurrents", 0x025, 0x5425, false, kLine, kCurrents},
    {"RearCurrents", 0x026, 0x5426, false, kLine, kCurrents},
    {"LeftForces1To3", 0x027, 0x5427, false, kLine, kForces1To3},
    {"LeftForces4To6", 0x028, 0x5428, false, kLine, kForces4To6},
    {"RightForces1To3", 0x029, 0x5429, false, kLine, kForces1To3},
    {"RightForces4To6", 0x02A, 0x542A, false, kLine, kForces4To6},
    {"ArmResult", 0x02B, 0x542B, false, kLine, kArmResult},
    {"RearLeftForces1To3", 0x02C, 0x542C, false, kLine, kForces1To3},
    {"RearLeftForces4To6", 0x02D, 0x542D, false, kLine, kForces4To6},
    {"RearRightForces1To3", 0x02E, 0x542E, false, kLine, kForces1To3},
    {"RearRightForces4To6", 0x02F, 0x542F, false, kLine, kForces4To6},
    {"Differential", 0x030, 0x5430, false, kLine, kDifferential},
}};

}  // namespace

std::span<const FrameLayout, kFrameKinds> frameLayouts()
{
    return kLayouts;
}

const FrameLayout& layoutOf(FrameKind kind)
{
    const auto i = static_cast<std::size_t>(kind);
    if (i >= kFrameKinds) throw std::invalid_argument("layoutOf: no such FrameKind");
    return kLayouts[i];
}

std::optional<FrameKind> kindOfId(std::uint32_t id)
{
    const auto layouts = frameLayouts();
    for (std::size_t i = 0; i < layouts.size(); ++i)
        if (layouts[i].id == id) return static_cast<FrameKind>(i);
    return std::nullopt;
}

std::int64_t leastRaw(const SignalLayout& signal)
{
    return std::llround(signal.least / signal.scale);
}

std::int64_t mostRaw(const SignalLayout& signal)
{
    return std::llround(signal.most / signal.scale);
}

}  // namespace terratact
