#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/message.h"
#include "core/infer/estimate/estimate.h"

namespace terratact {

// The ghost is the last estimate moved by odometry while the robot drives, with the uncertainty
// that the motion adds.

/// Motion of the IMU since a scene (ghost_track.h). Axes along gravity, as in the DEM frame.
struct ImuMotion {
    double forward = 0.0, up = 0.0;  ///< [m]
    double way = 0.0;  ///< distance rolled by the tracks, forward and backward added [m]
    /// Displacement by one sd of slip along the ground [m]; the two are fully correlated.
    double slipForward = 0.0, slipUp = 0.0;
    double upSd = 0.0;  ///< further sd of the IMU's height [m]
    bool operator==(const ImuMotion&) const = default;
};

/// Height that was estimated at an earlier pose [m], in the DEM frame of now.
struct GhostBin {
    double height = 0.0, sd = 0.0, q10 = 0.0, q90 = 0.0;
    bool operator==(const GhostBin&) const = default;
};

struct Ghost {
    std::array<std::optional<GhostBin>, kBins> bin{};
    ImuMotion motion;
    bool operator==(const Ghost&) const = default;
};

/// Returns the estimate in the DEM frame of the moved robot. Heights, sd and distances of the
/// quantiles are interpolated linearly between the old bins. A bin is empty outside the old bins,
/// and where a neighbour was prior only: its height was never estimated. Every bin widens by w:
///   sd² → sd² + w²,   |q − height|² → |q − height|² + (1.28 w)²,
///   w² = (g · slipForward − slipUp)² + upSd²
/// g is the slope to that neighbour for which the first term is larger. No motion returns the
/// estimate unchanged.
Ghost ghostOf(const TerrainEstimate& estimate, const ImuMotion& motion);

/// Reason why an estimate has no ghost, or has none any more.
enum class NoGhost : std::uint8_t {
    NoOdometry,    ///< the robot reports no odometry
    TooFar,        ///< the robot drove further than GhostLimits::way
    TooUncertain,  ///< no bin has an sd below GhostLimits::sd
    Tilted,        ///< pitch or roll changed too much for one profile of the ground
    Turned,        ///< the robot's heading changed too much
    TelemetryGap,  ///< telemetry was silent for too long
    NothingLeft,   ///< no bin of the ghost lies within the robot's bins
};

/// Returns a sentence such as "the robot reports no odometry".
SourceText describe(NoGhost why);

}  // namespace terratact
