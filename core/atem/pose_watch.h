#pragma once

#include <cstdint>

#include "core/robot/measurement.h"

namespace terratact {

/// Notices that the robot has left the pose of a scene: it drives, its attitude or a flipper has changed, or its tracks
/// have moved.  Once left it stays left.
class PoseWatch {
public:
    // Another pose beyond these.  Of pitch and roll each: five standard deviations of an MTi's difference of two.  An
    // encoder resolves 1 mrad of a flipper and 0.1 mm of a track: the rest is for what gives without a move.
    static constexpr double kTilt = 0.06;  ///< [rad] of pitch, of roll
    static constexpr double kFlipper =
        0.05;  ///< [rad] of each by itself: opposite turns tilt no pair
    static constexpr double kTravelled = 0.025;  ///< [m] a quarter of a bin
    static constexpr double kTurned = 0.05;      ///< [rad] 4 cm sideways at the foremost bin

    explicit PoseWatch(const Measurement& scene) : scene_(scene) {}

    /// The newest telemetry, the count-th since the source was opened (1 for the first); the same may be looked at
    /// again.  Two that differ have to say so in a row: one outlier of the IMU ends nothing.
    void look(const Measurement& newest, std::uint64_t count);

    bool hasMoved() const { return moved_; }

private:
    bool differs(const Measurement& newest) const;
    bool tracksMoved(const Measurement& newest) const;

    Measurement scene_;
    std::uint64_t suspectedAt_ = 0;  ///< count of the first that said so; 0: the newest does not
    bool moved_ = false;
};

}  // namespace terratact
