#pragma once

#include <cstdint>

#include "core/robot/measurement.h"

namespace terratact {

/// Detects that the robot has left the pose of a scene. It drives, its attitude or a flipper has
/// changed, or its tracks have moved. The result stays true.
class PoseWatch {
public:
    // Changes beyond these limits are another pose. The limit of pitch and roll is five standard
    // deviations of the difference of two MTi readings. An encoder resolves 1 mrad of a flipper and
    // 0.1 mm of a track; the rest allows for elastic give.
    static constexpr double kTilt = 0.06;  ///< [rad] of pitch or roll
    /// [rad] of each flipper: opposite turns would leave a pair's mean.
    static constexpr double kFlipper = 0.05;
    static constexpr double kTravelled = 0.025;  ///< [m], a quarter of a bin
    static constexpr double kTurned = 0.05;      ///< [rad], 4 cm sideways at the foremost bin

    explicit PoseWatch(const Measurement& scene) : scene_(scene) {}

    /// Reads the newest telemetry, the count-th since the source was opened (1 for the first). The
    /// same line may be read again. Two different lines in a row must differ from the scene: one
    /// outlier of the IMU has no effect.
    void poll(const Measurement& newest, std::uint64_t count);

    bool hasMoved() const { return moved_; }
    /// Returns true if the body has moved by tilt or tracks, so that the scene's heights belong to
    /// another place. A drive counts if it reports no odometry. A drive without motion, or a
    /// flipper alone, leaves the ground below unchanged.
    bool hasLeft() const { return left_; }

private:
    bool differs(const Measurement& newest) const;
    bool tilted(const Measurement& newest) const;
    bool bodyMoved(const Measurement& newest) const;
    bool tracksMoved(const Measurement& newest) const;

    Measurement scene_;
    /// Count of the first line that differs; 0: the newest does not.
    std::uint64_t suspectedAt_ = 0;
    std::uint64_t suspectedLeftAt_ = 0;  ///< same for the body
    bool moved_ = false, left_ = false;
};

}  // namespace terratact
