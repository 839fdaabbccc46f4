#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "app/modelling/simulation/hazard_scenes.h"
#include "core/atem/atem_machine.h"

namespace terratact {

/// Drives of feel forward on generated ground, with a simulated operator who only holds the control.
struct FeelForwardTrial {
    int drives = 50;
    std::uint64_t seed = 1;   ///< seed of ground, drives and noise
    double stepLimit = 0.10;  ///< [m] obstacle height, see hasStep()
    Settings settings;        ///< of the estimates
    /// [s] duration of an estimate in the time model, with its advice and the console's ticks.
    double estimateSeconds = 0.2;
    bool isBlind = false;  ///< advances with any verdict, as a comparison
};

/// Conditions of one drive. Successive drives cycle through all grounds, hazards and kinds of ground.
struct FeelForwardDrive {
    std::size_t ground = 0;  ///< index into kHazardGrounds
    std::optional<Hazard> hazard{};
    bool tracks = false;      ///< two tracks, with the hazard on one side or on both
    bool onBothSides = true;  ///< with tracks
};
std::vector<FeelForwardDrive> feelForwardDrives(int drives, bool tracks);

/// Result of some drives.
struct FeelForwardCounts {
    std::size_t drives = 0;
    std::size_t presses = 0;   ///< in the loop
    std::size_t advances = 0;  ///< of the loop
    double advanced = 0.0;     ///< [m] true way of all advances
    double byHand = 0.0;       ///< [m] true way between two loops
    double seconds = 0.0;      ///< [s] time of the loops
    std::map<LoopEnd, std::size_t> ends{};
    std::map<AtemFailure, std::size_t> failures{};
    /// Drives that ended because the loop's advance led over a fall, or into a rise, above the step limit.
    std::size_t falls = 0, collisions = 0;
    /// Advances in which a raised front flipper touched ground more than the step limit above the tracks.
    std::size_t touches = 0;
    /// Drives that ended before the hazard or at the end of the ground.
    std::size_t beforeHazard = 0, atEnd = 0;

    FeelForwardCounts& operator+=(const FeelForwardCounts& other);
    double metresPerMinute() const;  ///< pace of the loops; 0 without one
};

/// Drives once. The loop runs on the state machine of the console (core/atem/atem_machine.h), in steps of 0.04 s. The
/// simulated robot obeys Press and Advance. Where the loop asks, the operator lets go. If the true ground ahead is
/// free, the operator drives 0.1 m by hand and holds again. No probe is made. The drive ends before a true step or at
/// the end of the ground. It also ends with a fault, a fall or a collision. seed: of ground, noise and slip.
FeelForwardCounts feelForwardOnce(const EstimatorBundle& bundle, const FeelForwardTrial& trial,
                                  const FeelForwardDrive& drive, std::uint64_t seed);

/// One row of the result.
struct FeelForwardLine {
    std::string what;
    FeelForwardCounts counts;
};

/// Drives all drives on all cores. Rows: one plane and two tracks by hazard, then each ground, then all. Two tracks
/// only if the model has them.
std::vector<FeelForwardLine> tryFeelForward(const EstimatorBundle& bundle,
                                            const FeelForwardTrial& trial);

/// Returns tables for the terminal: rows, then the ends by reason.
std::string feelForwardTable(std::span<const FeelForwardLine> lines, const RobotModel& robot,
                             const FeelForwardTrial& trial);

}  // namespace terratact
