#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/force_sensor.h"
#include "core/robot/measurement.h"

namespace terratact {

/// A point or vector of the sagittal plane: x forward, z up [m].
struct Vec2 {
    double x = 0.0;
    double z = 0.0;
    bool operator==(const Vec2&) const = default;
};

/// Returns the scalar product.
constexpr double dot(Vec2 a, Vec2 b)
{
    return a.x * b.x + a.z * b.z;
}

/// Convex hull of two circles; equal centres and radii make a disc.
struct TaperedHull {
    Vec2 a, b;                  ///< circle centres [m]
    double ra = 0.0, rb = 0.0;  ///< radii [m]
};

/// A flipper at joint angle 0: pivot circle, tip circle, lower edge flat with the tracks' lower edge.
struct FlipperGeometry {
    Vec2 pivot;                 ///< base frame [m]
    double pivotRadius = 0.0;   ///< [m]
    double tipRadius = 0.0;     ///< [m]
    double axleDistance = 0.0;  ///< [m] pivot to tip circle's centre
    double mass = 0.0;          ///< [kg] both flippers of the axle
    double comDistance = 0.0;   ///< [m] pivot to centre of mass, along the flipper

    /// Returns half the taper's opening angle: asin((pivotRadius − tipRadius) / axleDistance)
    /// [rad]. Returns 0 if one circle contains the other: such a flipper is a disc.
    double taper() const;
    /// Returns the length of the straight lower edge between the two circles [m]: axleDistance
    /// cos(taper).
    double edgeLength() const;
};

/// Distances from the robot's middle plane [m]: the left part is at +y, the right one at −y.
struct LateralGeometry {
    double trackY = 0.1985;       ///< middle of a track
    double trackWidth = 0.097;    ///< of a track
    double flipperY = 0.272;      ///< middle of a flipper, front and rear alike
    double flipperWidth = 0.050;  ///< of a flipper
    double bodyComY = 0.0;        ///< centre of mass of the body, left positive
    bool operator==(const LateralGeometry&) const = default;
};

/// Joint between the tracks. Each track with its flippers turns about the base's y axis against the
/// body. The left one turns by +angle, nose up, and the right one by −angle. A locked differential
/// has the angle 0. An unlocked one turns freely within ±limit, and the robot measures its angle.
struct TrackDifferential {
    bool locked = true;
    double limit = 0.7;  ///< [rad]
    bool operator==(const TrackDifferential&) const = default;
};

/// Tracked robot with front and rear flippers, as resources/robots/*.toml describe it. Base frame:
/// x forward, z up, origin midway between the tracks, `baseHeight` above flat ground.
struct RobotModel {
    std::string name;
    double baseHeight = 0.0;              ///< [m]
    Vec2 imu;                             ///< origin of the DEM frame, base frame [m]
    double trackAxle = 0.0;               ///< [m] distance of the track wheels' axles
    double trackRadius = 0.0;             ///< [m]
    double trackZ = 0.0;                  ///< [m] wheel centre, base frame
    std::vector<std::vector<Vec2>> body;  ///< convex polygons, base frame
    FlipperGeometry front, rear;
    double bodyMass = 0.0;  ///< [kg] everything but the flippers
    Vec2 bodyCom;           ///< base frame [m]
    /// Positions of the elements on the front flippers' lower edge, from its pivot end (0) to its
    /// tip end (1). Element 6 is last.
    std::array<double, kForceElements> elementShare{};
    /// Positions of the elements of the rear flippers' arrays; empty: the rear flippers have none.
    std::optional<std::array<double, kForceElements>> rearElementShare{};
    double forceSaturation = 0.0;  ///< largest reading of an element [N]
    /// Force arrays in display order. An element of a side belongs to at most one array. Of the two elements with the
    /// same number, at least one belongs to an array. Otherwise every estimate would lack a force.
    std::vector<ForceArrayLayout> forceArrays = leftAndRightArrays();
    ForceCalibration forceCalibration;
    double torquePerAmpere = 0.0;   ///< [N m / A] of one flipper motor
    double maxFlipperTorque = 0.0;  ///< [N m] one motor, at the output
    double flipperSpeed = 0.0;      ///< [rad/s]
    /// Range of x in the DEM frame that the arm can probe [m].
    double armReachBegin = 0.0, armReachEnd = 0.0;
    double armReachY = 0.3;  ///< farthest reach of the arm to both sides of the middle [m]
    double armSd = 0.0;      ///< sd of an arm reading [m]
    /// Sd of a travelled distance as a share of that distance: the tracks slip. core/strip/dead_reckoning.h
    /// makes it an uncertainty; simulated robots have a slipShare of their own.
    double travelledSdShare = 0.0;
    double pitchSd = 0.0;  ///< [rad] sd of the IMU's pitch

    LateralGeometry lateral;
    TrackDifferential differential;

    /// Distance from the middle to the outer edge of a track [m], for tipping over sideways
    /// (core/robot/attitude.h).
    double halfWidth = 0.25;

    double totalMass() const { return bodyMass + front.mass + rear.mass; }

    /// Returns true if the arm can touch the ground at the bin's centre on that side's line
    /// (sideHeights(), core/terrain/ground_lines.h). Throws std::invalid_argument unless 0 ≤ bin ≤ 10.
    /// Defined in core/terrain/arm_reach.cpp, because only core/terrain defines the bins.
    bool armReaches(int bin, ProbeSide side = ProbeSide::Middle) const;
};

inline constexpr std::size_t kMaxForceArrays = 4;           ///< most arrays that a console can show
inline constexpr std::size_t kMaxForceArrayNameLength = 6;  ///< [bytes]

/// Reads a robot file (TOML; resources/robots/absolem.toml shows every key with its unit). Every
/// key is required, and no other key is allowed, except for these tables. There may be one to four
/// tables
///   [[force_array]]
///   name = "L"             # 1 to 6 bytes
///   side = "left"          # or "right": the side whose six elements the link carries
///   elements = [1, 2, 3]   # a subset of them, 1 at the pivot and 6 at the tip
/// Without these tables there are two arrays: all left elements and all right elements. There may
/// be one table each of
///   [lateral]              # left and right; Absolem's numbers without the table
///   track_y_m, track_width_m, flipper_y_m, flipper_width_m, body_com_y_m
///   [track_differential]   # locked without the table
///   state = "locked"       # or "free": it turns, and the robot measures its angle
///   limit_rad = 0.7
///   [arm_side]             # 0.3 without the table
///   reach_y_m              # farthest reach of the arm to both sides of the middle
///   [rear_force_elements]  # without the table the rear flippers have none
///   edge_share             # as in [force_elements]
///   [tip_over]
///   half_width_m = 0.25    # from the middle to the outer edge of a track. Without the table it
///                          # follows from [lateral]; it is 0.25 if that is absent too.
/// Errors name the file, the line, the key and what was expected. Files over 64 KiB, or nested
/// deeper than 16 levels, are refused before they are parsed. robot_model.cpp has the range of each
/// key; the messages are those of core/robot/toml_section.h.
Result<RobotModel> readRobotModel(const std::string& path);

/// Reads the same from a text; errors call it `name`.
Result<RobotModel> robotModelFrom(const std::string& name, const std::string& text);

}  // namespace terratact
