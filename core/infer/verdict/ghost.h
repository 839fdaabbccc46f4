#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/message.h"
#include "core/infer/estimate/estimate.h"
#include "core/strip/dead_reckoning.h"
#include "core/strip/height_band.h"

namespace terratact {

// The ghost is the last estimate moved by odometry while the robot drives, with the uncertainty
// that the motion adds.

using GhostBin = HeightBand;

struct Ghost {
    /// Heights that were estimated at an earlier pose [m], in the DEM frame of now.
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
