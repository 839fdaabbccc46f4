#pragma once

#include <optional>

#include "core/infer/verdict/ghost.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Dead reckoning: adds up the steps between lines of telemetry. A step of ds along the tracks
/// moves the robot by ds (cos θ, sin θ). θ is the mean of its two pitches. The robot turns about a
/// point of the tracks' lower edge under the base origin. That point is uncertain along the track,
/// between its axles:
///   slip  = share (Σ |ds| cos θ, Σ |ds| sin θ)
///   upSd² = (pitchSd Σ |ds|)² + (trackAxle / √12 · max |θ − θ₀|)²
/// share and pitchSd are the robot's. The last term is the sd of a point that lies anywhere between
/// the axles.
class DeadReckoning {
public:
    /// travelled [m], pitch [rad]: of the scene. Both functions throw std::invalid_argument for a
    /// number that is not finite.
    DeadReckoning(const RobotModel& robot, double travelled, double pitch);

    void add(double travelled, double pitch);
    ImuMotion motion() const;
    double pitchChange() const { return pitch_ - startPitch_; }  ///< [rad]

private:
    double share_, pitchSd_, pivotSd_;
    Vec2 imu_;  ///< from the point of the tracks below the base origin to the IMU [m]
    double travelled_, startPitch_, pitch_;
    Vec2 rolled_;                 ///< [m]
    double way_ = 0.0;            ///< [m] Σ |ds|
    Vec2 wayAlong_;               ///< [m] Σ |ds| (cos θ, sin θ)
    double largestChange_ = 0.0;  ///< largest change of the pitch [rad]
};

/// Limits beyond which there is no ghost.
struct GhostLimits {
    double way = 1.0;              ///< distance rolled [m]
    double sd = 0.15;              ///< sd of the most certain bin [m]
    double tilt = 0.35;            ///< [rad] change of pitch or roll
    double turn = 0.10;            ///< change of heading [rad]
    double silence = kMaxSilence;  ///< [s] between two lines of telemetry
};

/// Follows one estimate along the telemetry after its scene. A ghost that has ended stays ended.
class GhostTrack {
public:
    /// scene: the telemetry that the estimate rests on. It may be old: the robot stands still while
    /// estimates and probes take their time.
    GhostTrack(const RobotModel& robot, const TerrainEstimate& estimate, const Measurement& scene,
               const GhostLimits& limits = {});

    /// The next line of telemetry.  Does nothing after the end.
    void add(const Measurement& measurement);
    /// Ends the ghost because telemetry was silent for too long by the caller's clock.
    void addSilence();

    const std::optional<Ghost>& ghost() const { return ghost_; }
    /// Returns why ghost() is empty; empty while there is a ghost.
    std::optional<NoGhost> why() const { return why_; }

private:
    std::optional<NoGhost> judge(const Measurement& measurement) const;
    void end(NoGhost why);

    TerrainEstimate estimate_;
    GhostLimits limits_;
    Measurement scene_;
    std::optional<double> newestTelemetry_;  ///< time of the newest telemetry [s]
    std::optional<DeadReckoning> reckoning_;
    std::optional<Ghost> ghost_;
    std::optional<NoGhost> why_;
};

}  // namespace terratact
