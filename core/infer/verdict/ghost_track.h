#pragma once

#include <optional>

#include "core/infer/verdict/ghost.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/strip/dead_reckoning.h"

namespace terratact {

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
