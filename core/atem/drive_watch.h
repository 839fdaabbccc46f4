#pragma once

#include <cmath>
#include <optional>

#include "core/robot/measurement.h"

namespace terratact {

/// Detects a drive without motion: the robot reports that it drives, but neither its tracks nor its
/// flippers move. It has no clock: `now` is any monotonic clock [s].
class DriveWatch {
public:
    static constexpr double kStandsFor = 1.0;  ///< [s] without motion before it is reported
    static constexpr double kWay = 0.005;      ///< [m] of the tracks
    /// [rad] of a front flipper, which rises before the tracks move.
    static constexpr double kTurn = 0.02;

    /// Reads the newest telemetry. Returns true once for each drive without motion for kStandsFor.
    /// Always false without odometry.
    bool poll(const Measurement& m, double now)
    {
        if (m.activity != RobotActivity::Driving || !m.travelled) {
            since_.reset();
            reported_ = false;
            return false;
        }
        const bool moved = !since_ || std::abs(*m.travelled - way_) > kWay
                        || std::abs(m.frontLeft - front_) > kTurn;
        if (moved) {
            since_ = now;
            way_ = *m.travelled;
            front_ = m.frontLeft;
            reported_ = false;
            return false;
        }
        if (reported_ || now - *since_ < kStandsFor) return false;
        reported_ = true;
        return true;
    }

private:
    std::optional<double> since_;  ///< time of the last motion [s]
    double way_ = 0.0, front_ = 0.0;
    bool reported_ = false;
};

}  // namespace terratact
