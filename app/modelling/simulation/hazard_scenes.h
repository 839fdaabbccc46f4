#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string_view>
#include <vector>

#include "core/learn/data/drive_lines.h"
#include "core/learn/data/scene.h"
#include "core/learn/data/two_track_scene.h"
#include "core/robot/robot_model.h"
#include "core/sim/ground/hazard_terrain.h"
#include "core/terrain/bins.h"
#include "core/terrain/ground_lines.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Ground on which hazards lie.
struct HazardGround {
    std::string_view name;
    double roughness = 0.0;  ///< G(n₀) of ISO 8608 [m³], see isoRoughness()
    bool isSoft = false;     ///< see randomSoftGround()
};
inline constexpr std::array kHazardGrounds{
    HazardGround{"level", 0.0, false},      HazardGround{"class A", 16e-6, false},
    HazardGround{"class C", 256e-6, false}, HazardGround{"soft", 0.0, true},
    HazardGround{"soft A", 16e-6, true},    HazardGround{"soft C", 256e-6, true}};

/// How a drive presses its front flippers and holds its rear ones.
enum class PressStyle : std::uint8_t {
    Random,  ///< randomDriveStyle()
    Console  ///< DriveStyle{}: the press torque of the console, rear flippers up a little
};

/// A scene with exact truth, and where the simulated robot truly pressed on the ground.
struct HazardScene {
    Scene scene;
    std::vector<double> contacts;  ///< x of every contact force [m], DEM frame, ascending
};

/// Returns the random ground of driveTowards(): the hazard between kHazardBegin and kHazardEnd, or none, and the
/// ground's roughness. A soft layer is not part of it.
TerrainProfile hazardProfile(const HazardGround& ground, std::optional<Hazard> hazard,
                             std::mt19937_64& rng);
/// Returns the random ground of driveTracksTowards().
GroundLines hazardLines(const RobotModel& robot, const HazardGround& ground,
                        std::optional<Hazard> hazard, bool onBothSides, std::mt19937_64& rng);

/// Drives once over random ground (core/sim/ground/hazard_terrain.h) and returns a scene every 0.1 m. The scenes reach
/// from 1 m before the earliest hazard to 0.5 m behind the latest. Without a hazard, the ground has its roughness
/// alone.
std::vector<HazardScene> driveTowards(const RobotModel& robot, const HazardGround& ground,
                                      std::optional<Hazard> hazard, PressStyle style,
                                      std::mt19937_64& rng);

/// Returns the same of two tracks: scenes with exact truth of both sides. The hazard lies on one side, chosen at
/// random, or on both. Roughness is correlated between the lines (core/sim/ground/random_ground.h).
std::vector<TwoTrackScene> driveTracksTowards(const RobotModel& robot, const HazardGround& ground,
                                              std::optional<Hazard> hazard, bool onBothSides,
                                              PressStyle style, std::mt19937_64& rng);

/// Returns the same drive with telemetry on the way (core/sim/way_drive.h). isNear() selects the scenes to judge.
DriveLines driveTracksAlong(const RobotModel& robot, const HazardGround& ground,
                            std::optional<Hazard> hazard, bool onBothSides, PressStyle style,
                            std::mt19937_64& rng);
/// Returns true if a scene of driveTracksAlong() stands near hazards, by its odometry, which slips.
bool isNear(const Measurement& scene);

/// Returns the heights of a scene whose truth is known. Throws std::bad_optional_access if one is not.
Heights knownHeights(const OptionalHeights& truth);

/// True heights of flat ground lie within this distance of a straight line [m].
inline constexpr double kFlatWithin = 0.02;

/// Returns true if the true ground from the first bin to lastBin is flat. It has no step above stepLimit [m]. Its bins
/// lie within kFlatWithin of the line through the two outer ones.
bool isFlatTo(const Heights& truth, double stepLimit, int lastBin);

/// A robot that presses leaves no longer stretch without a contact force [m].
inline constexpr double kMaxUnpressed = 0.05;

/// Returns true if the robot presses on all the ground from bin kFirstAhead to lastBin. No stretch longer than
/// kMaxUnpressed is without a contact.
bool isPressedTo(const std::vector<double>& contacts, int lastBin);

}  // namespace terratact
