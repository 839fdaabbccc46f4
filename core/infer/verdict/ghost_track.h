#pragma once

#include <optional>

#include "core/infer/verdict/ghost.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

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

/// Beyond these there is no ghost.
struct GhostLimits {
    double way = 1.0;              ///< [m]
    double sd = 0.15;              ///< [m] of its most certain bin
    double tilt = 0.35;            ///< [rad] change of pitch or roll
    double turn = 0.10;            ///< [rad]
    double silence = kMaxSilence;  ///< [s] between two lines of telemetry
};

/// Follows one estimate along the telemetry after its scene.  What has ended stays ended.
class GhostTrack {
public:
    /// scene: the telemetry that the estimate rests on.  It may be long ago: estimates and probes take their time,
    /// and the robot stands meanwhile.
    GhostTrack(const RobotModel& robot, const TerrainEstimate& estimate, const Measurement& scene,
               const GhostLimits& limits = {});

    /// The next line of telemetry.  Does nothing after the end.
    void take(const Measurement& measurement);
    /// There was none for too long, by a clock that its lines do not tell of.
    void takeSilence();

    const std::optional<Ghost>& ghost() const { return ghost_; }
    /// Set where ghost() is empty.
    std::optional<NoGhost> why() const { return why_; }

private:
    std::optional<NoGhost> judge(const Measurement& measurement) const;
    void end(NoGhost why);

    TerrainEstimate estimate_;
    GhostLimits limits_;
    Measurement scene_;
    std::optional<double> heard_;  ///< [s] of the newest telemetry
    std::optional<DeadReckoning> reckoning_;
    std::optional<Ghost> ghost_;
    std::optional<NoGhost> why_;
};

}  // namespace terratact
