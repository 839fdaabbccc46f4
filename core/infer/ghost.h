#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/infer/estimate.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

// The last estimate while the robot drives on: where odometry says it lies now, and how much less certain that
// makes it.

/// How the IMU has moved since a scene, by dead reckoning.  Axes along gravity, as the DEM frame's.
struct ImuMotion {
    double forward = 0.0, up = 0.0;  ///< [m]
    double way = 0.0;                ///< [m] rolled by the tracks, forth and back both counted
    /// [m] of one sd of slip, which moves the robot along the ground: not independent of each other.
    double slipForward = 0.0, slipUp = 0.0;
    double upSd = 0.0;  ///< [m] of what else makes the IMU's height uncertain
    bool operator==(const ImuMotion&) const = default;
};

/// Adds up the steps between lines of telemetry.  A step of ds along the tracks at the mean θ of its two pitches
/// moves the robot by ds (cos θ, sin θ).  It turns about a point of the tracks' lower edge: under the base origin,
/// plus or minus what it may lie before or behind it,
///   slip  = share (Σ |ds| cos θ, Σ |ds| sin θ)
///   upSd² = (pitchSd Σ |ds|)² + (trackAxle / √12 · max |θ − θ₀|)²,
/// share and pitchSd the robot's, the second term that of a point anywhere between the tracks' axles.
class DeadReckoning {
public:
    /// travelled [m], pitch [rad]: of the scene.  Throws std::invalid_argument unless finite, as take() does.
    DeadReckoning(const RobotModel& robot, double travelled, double pitch);

    void take(double travelled, double pitch);
    ImuMotion motion() const;
    double pitchChange() const { return pitch_ - startPitch_; }  ///< [rad]

private:
    double share_, pitchSd_, pivotSd_;
    Vec2 imu_;  ///< from the point of the tracks below the base origin
    double travelled_, startPitch_, pitch_;
    Vec2 rolled_;                 ///< [m]
    double way_ = 0.0;            ///< [m] Σ |ds|
    Vec2 wayAlong_;               ///< [m] Σ |ds| (cos θ, sin θ)
    double largestChange_ = 0.0;  ///< [rad] of the pitch
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

/// Beyond these there is no ghost.
struct GhostLimits {
    double way = 1.0;      ///< [m]
    double sd = 0.15;      ///< [m] of its most certain bin
    double tilt = 0.35;    ///< [rad] change of pitch or roll
    double turn = 0.10;    ///< [rad]
    double silence = 1.0;  ///< [s] between two lines of telemetry
};

/// Follows one estimate along the telemetry after its scene.  What has ended stays ended.
class GhostTrack {
public:
    /// scene: the telemetry that the estimate rests on.
    GhostTrack(const RobotModel& robot, const TerrainEstimate& estimate, const Measurement& scene,
               const GhostLimits& limits = {});

    /// The next line of telemetry.  Does nothing after the end.
    void take(const Measurement& measurement);

    const std::optional<Ghost>& ghost() const { return ghost_; }
    /// Set where ghost() is empty.
    std::optional<NoGhost> why() const { return why_; }

private:
    std::optional<NoGhost> judge(const Measurement& measurement) const;
    void end(NoGhost why);

    TerrainEstimate estimate_;
    GhostLimits limits_;
    Measurement scene_, last_;
    std::optional<DeadReckoning> reckoning_;
    std::optional<Ghost> ghost_;
    std::optional<NoGhost> why_;
};

}  // namespace terratact
