#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>

#include "core/base/message.h"
#include "core/limits.h"
#include "core/robot/probe_side.h"

namespace terratact {

inline constexpr int kForceElements = 6;

/// Number of features of s. In order: pitch, front and rear flipper angle, front and rear current,
/// six forces.
inline constexpr std::size_t kFeatures = 5 + kForceElements;

/// Features of s that were not measured: bit d is feature d. Pitch and the flipper angles are
/// always measured.
using MissingFeatures = std::bitset<kFeatures>;
inline constexpr std::size_t kFrontCurrentFeature = 3, kRearCurrentFeature = 4,
                             kFirstForceFeature = 5;

inline constexpr std::size_t kMotors = 4;  ///< of the flippers

/// Currents of the flippers' motors [A], positive = pressing down: front left, front right, rear
/// left, rear right. An empty optional means "not measured".
using MotorCurrents = std::array<std::optional<double>, kMotors>;

/// The proprioceptive vector s of the paper, left and right flippers averaged. Where only one side of
/// a current or force was measured, it is the value of that side.
/// An empty optional means "not measured"; every present value is finite.
struct Proprioception {
    double pitch = 0.0;  ///< [rad] nose up positive
    double front = 0.0;  ///< [rad] front flippers, 0 = lower edge flat, tip up positive
    double rear = 0.0;   ///< [rad] rear flippers, tip up positive
    std::optional<double> frontCurrent;  ///< [A] per motor, positive = pressing down
    std::optional<double> rearCurrent;   ///< [A] per motor, positive = pressing down
    std::array<std::optional<double>, kForceElements> force{};  ///< [N] element 1 (pivot) … 6 (tip)
    bool operator==(const Proprioception&) const = default;
};

/// Activity that the robot reports.
enum class RobotActivity : std::uint8_t { Halted, Driving, Pressing, Pressed, Probing, Stopped };

/// Reason why the robot refused the last command.
enum class Refusal : std::uint8_t {
    None,
    StopLatched,
    Busy,
    OutOfReach,
    NotPressed,
    NoRestPose,
    NotArmed,
    WrongEpoch,  ///< the command belongs to an earlier arming
    OutOfLimits,
};

SourceText describe(RobotActivity activity);
SourceText describe(Refusal refusal);

/// Terrain height measured by the arm's tip.
struct ArmReading {
    int bin = 0;          ///< index 0 … 10, see core/terrain/bins.h
    double height = 0.0;  ///< [m] DEM frame
    double sd = 0.03;     ///< [m]
    ProbeSide side = ProbeSide::Middle;
    bool operator==(const ArmReading&) const = default;
};

/// Forces [N] of the elements of a left and a right flipper, element 1 (pivot) … 6 (tip). Empty: the
/// element is not known by itself, the robot does not have it, or it is broken.
struct SideForces {
    std::array<std::optional<double>, kForceElements> left{}, right{};

    /// Returns true if a side of element `e` (0 … 5) is known.
    bool knows(std::size_t e) const { return left[e] || right[e]; }
    bool operator==(const SideForces&) const = default;
};

/// One line of telemetry. Plain values; every number is finite, and 0 if it was not measured.
struct Measurement {
    double time = 0.0;   ///< [s] on the source's own clock
    double pitch = 0.0;  ///< [rad] nose up positive
    double roll = 0.0;   ///< [rad] left side up positive
    double frontLeft = 0.0, frontRight = 0.0, rearLeft = 0.0,
           rearRight = 0.0;                                  ///< [rad] tip up positive
    double frontLeftCurrent = 0.0, frontRightCurrent = 0.0;  ///< [A] positive = pressing down
    double rearLeftCurrent = 0.0, rearRightCurrent = 0.0;    ///< [A] positive = pressing down
    /// Of the front flippers [N], calibrated, element 6 at the tip: mean of both `sides`, or the side
    /// that is known.
    std::array<double, kForceElements> force{};
    RobotActivity activity = RobotActivity::Halted;
    Refusal refusal = Refusal::None;  ///< reason for refusing the last command
    std::optional<ArmReading> arm;    ///< last completed probe at this pose
    /// Odometry since the robot's start; empty: not measured.
    std::optional<double> travelled{};  ///< [m] along the tracks, forward positive
    std::optional<double> turned{};     ///< [rad] left positive, wrapped to one turn
    /// Currents (of both sides) and forces that were not measured.
    MissingFeatures missing{};
    /// Motors whose current was not measured although the other one of their axle was, in the order
    /// of MotorCurrents.
    std::bitset<kMotors> missingMotors{};
    /// Forces of each side. Sessions of versions 1 to 3 do not have them.
    SideForces sides{};                    ///< front flippers
    SideForces rearSides{};                ///< rear flippers, if the robot has elements there
    std::optional<double> differential{};  ///< [rad] left track nose up; empty: locked
    bool operator==(const Measurement&) const = default;
};

/// Returns the mean of both sides, or the side that is known; empty if none is.
std::optional<double> meanOfSides(const std::optional<double>& left,
                                  const std::optional<double>& right);

/// Returns the current of each motor.
MotorCurrents motorCurrents(const Measurement& measurement);

/// Sets the current of each motor, `missingMotors`, and the currents of `missing`.
void setCurrents(Measurement& measurement, const MotorCurrents& currents);

/// Sets the forces of each side, and `force` and `missing` to their means. The mean of an element with
/// one known side is that side. An element without a known side is missing.
void setSides(Measurement& measurement, const SideForces& sides);

/// Returns s with the meanOfSides() of left and right. Features that were not measured are empty.
Proprioception proprioception(const Measurement& measurement);

/// Returns value, or NaN if the measurement lacks that feature, for display.
double shownFeature(const Measurement& measurement, std::size_t feature, double value);

/// Returns the features that are empty.
MissingFeatures missingFeatures(const Proprioception& s);

/// Returns the shortest turn from one angle to another [rad], for angles such as
/// Measurement::turned.
double turnBetween(double from, double to);

/// Returns the larger left/right difference, of the front or the rear flippers [rad].
double flipperAsymmetry(const Measurement& measurement);

}  // namespace terratact
