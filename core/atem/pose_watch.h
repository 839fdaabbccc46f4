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
    void poll(const Measurement& newest, std::uint64_t count);

    bool hasMoved() const { return moved_; }
    /// The body has moved, so that heights of the scene are of another place: by tilt or tracks, or it drives and says
    /// nothing of its tracks.  A drive that moved nothing, and a flipper alone, leave the ground below where it was.
    bool hasLeft() const { return left_; }

private:
    bool differs(const Measurement& newest) const;
    bool tilted(const Measurement& newest) const;
    bool bodyMoved(const Measurement& newest) const;
    bool tracksMoved(const Measurement& newest) const;

    Measurement scene_;
    std::uint64_t suspectedAt_ = 0;  ///< count of the first that said so; 0: the newest does not
    std::uint64_t suspectedLeftAt_ = 0;  ///< likewise
    bool moved_ = false, left_ = false;
};

}  // namespace terratact
