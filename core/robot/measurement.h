#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>

namespace terratact {

inline constexpr int kForceElements = 6;

/// The features of s in order: pitch, front and rear flipper angle, front and rear current, six forces.
inline constexpr std::size_t kFeatures = 5 + kForceElements;

/// Features of s that were not measured: bit d is feature d.  Pitch and the flipper angles are always measured.
using MissingFeatures = std::bitset<kFeatures>;
inline constexpr std::size_t kFrontCurrentFeature = 3, kRearCurrentFeature = 4,
                             kFirstForceFeature = 5;

/// The proprioceptive vector s of the paper, left and right flippers averaged.
/// An empty optional is "not measured"; every present value is finite.
struct Proprioception {
    double pitch = 0.0;  ///< [rad] nose up positive
    double front = 0.0;  ///< [rad] front flippers, 0 = lower edge flat, tip up positive
    double rear = 0.0;   ///< [rad] rear flippers, tip up positive
    std::optional<double> frontCurrent;  ///< [A] per motor, positive = pressing down
    std::optional<double> rearCurrent;   ///< [A] per motor, positive = pressing down
    std::array<std::optional<double>, kForceElements> force{};  ///< [N] element 1 (pivot) … 6 (tip)
    bool operator==(const Proprioception&) const = default;
};

/// What the robot says it is doing.
enum class RobotActivity : std::uint8_t { Halted, Driving, Pressing, Pressed, Probing, Stopped };

/// Why the robot did not do as told.
enum class Refusal : std::uint8_t {
    None,
    StopLatched,
    Busy,
    OutOfReach,
    NotPressed,
    NoRestPose,
    NotArmed,
    WrongEpoch,  ///< the command was meant for an earlier arming
    OutOfLimits,
};

std::string describe(RobotActivity activity);
std::string describe(Refusal refusal);

/// A terrain height measured by the arm's tip.
struct ArmReading {
    int bin = 0;          ///< index 0 … 10, see core/terrain/bins.h
    double height = 0.0;  ///< [m] DEM frame
    double sd = 0.03;     ///< [m]
    bool operator==(const ArmReading&) const = default;
};

/// One line of telemetry.  Plain values; every number is finite, and 0 where it was not measured.
struct Measurement {
    double time = 0.0;   ///< [s] on the source's own clock
    double pitch = 0.0;  ///< [rad] nose up positive
    double roll = 0.0;   ///< [rad] left side up positive
    double frontLeft = 0.0, frontRight = 0.0, rearLeft = 0.0,
           rearRight = 0.0;                                  ///< [rad] tip up positive
    double frontLeftCurrent = 0.0, frontRightCurrent = 0.0;  ///< [A] positive = pressing down
    double rearLeftCurrent = 0.0, rearRightCurrent = 0.0;    ///< [A] positive = pressing down
    std::array<double, kForceElements> force{};  ///< [N] calibrated, element 6 at the tip
    RobotActivity activity = RobotActivity::Halted;
    Refusal refusal = Refusal::None;  ///< of the last command
    std::optional<ArmReading> arm;    ///< last completed probe at this pose
    /// Odometry since the robot's start; empty: not measured.
    std::optional<double> travelled{};  ///< [m] along the tracks, forward positive
    std::optional<double> turned{};     ///< [rad] left positive, wrapped to one turn
    /// Currents (of both sides) and forces that were not measured.
    MissingFeatures missing{};
    bool operator==(const Measurement&) const = default;
};

/// Longer without telemetry [s], and the robot may have moved meanwhile without being seen.
inline constexpr double kMaxSilence = 1.0;

/// Averages left and right.  What the measurement lacks is empty.
Proprioception proprioception(const Measurement& measurement);

/// value, or NaN where the measurement lacks that feature: as numbers are shown.
double shownFeature(const Measurement& measurement, std::size_t feature, double value);

/// The features that are empty.
MissingFeatures missingFeatures(const Proprioception& s);

/// The shortest way round from one angle to another [rad], such as Measurement::turned.
double turnBetween(double from, double to);

/// The larger difference of left and right, of the front and of the rear flippers [rad].
double flipperAsymmetry(const Measurement& measurement);

}  // namespace terratact
