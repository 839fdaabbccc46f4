#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/infer/estimate/estimate.h"

namespace terratact {

// The last estimate while the robot drives on: where odometry says it lies now, and how much less certain that
// makes it.

/// How the IMU has moved since a scene (ghost_track.h).  Axes along gravity, as the DEM frame's.
struct ImuMotion {
    double forward = 0.0, up = 0.0;  ///< [m]
    double way = 0.0;                ///< [m] rolled by the tracks, forth and back both counted
    /// [m] of one sd of slip, which moves the robot along the ground: not independent of each other.
    double slipForward = 0.0, slipUp = 0.0;
    double upSd = 0.0;  ///< [m] of what else makes the IMU's height uncertain
    bool operator==(const ImuMotion&) const = default;
};

/// A height that was estimated elsewhere [m], DEM frame of now.
struct GhostBin {
    double height = 0.0, sd = 0.0, q10 = 0.0, q90 = 0.0;
    bool operator==(const GhostBin&) const = default;
};

struct Ghost {
    std::array<std::optional<GhostBin>, kBins> bin{};
    ImuMotion motion;
    bool operator==(const Ghost&) const = default;
};

/// The estimate in the DEM frame of a robot whose IMU has moved.  Between the bins of then, heights, sd and
/// distances of the quantiles are interpolated linearly; outside them there is nothing, nor where a neighbour was
/// prior only: that was never estimated.  Every bin widens by w:
///   sd² → sd² + w²,   |q − height|² → |q − height|² + (1.28 w)²,
///   w² = (g · slipForward − slipUp)² + upSd²,
/// with the steeper slope g to a neighbour, that counts more.  No motion: the estimate as it was.
Ghost ghostOf(const TerrainEstimate& estimate, const ImuMotion& motion);

/// Why there is no ghost of an estimate, or none any more.
enum class NoGhost : std::uint8_t {
    NoOdometry,  ///< the robot does not say how far it went
    TooFar,
    TooUncertain,  ///< what is left of it
    Tilted,        ///< pitch or roll changed too much for one profile of the ground
    Turned,        ///< the robot looks elsewhere
    Unheard,       ///< a while without telemetry
    NothingLeft,   ///< of it within the bins
};

/// "the robot reports no odometry" and the like.
std::string describe(NoGhost why);

}  // namespace terratact
