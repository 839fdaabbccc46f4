#pragma once

#include <cmath>
#include <optional>

#include "core/robot/measurement.h"

namespace terratact {

/// Notices a drive that moves nothing: the robot says that it drives, and neither its tracks nor its flippers move.  No
/// clock: `now` is any monotonic clock [s].
class DriveWatch {
public:
    static constexpr double kStandsFor = 1.0;  ///< [s] before it is said
    static constexpr double kWay = 0.005;      ///< [m] of the tracks
    static constexpr double kTurn =
        0.02;  ///< [rad] of a front flipper, which comes up before the tracks move

    /// The newest telemetry; true once for each drive that has stood for so long.  Never without odometry.
    bool poll(const Measurement& m, double now)
    {
        if (m.activity != RobotActivity::Driving || !m.travelled) {
            since_.reset();
            said_ = false;
            return false;
        }
        const bool moved = !since_ || std::abs(*m.travelled - way_) > kWay
                        || std::abs(m.frontLeft - front_) > kTurn;
        if (moved) {
            since_ = now;
            way_ = *m.travelled;
            front_ = m.frontLeft;
            said_ = false;
            return false;
        }
        if (said_ || now - *since_ < kStandsFor) return false;
        said_ = true;
        return true;
    }

private:
    std::optional<double> since_;  ///< [s] the last move
    double way_ = 0.0, front_ = 0.0;
    bool said_ = false;
};

}  // namespace terratact
