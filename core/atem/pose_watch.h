#pragma once

#include <cstdint>

#include "core/robot/measurement.h"

namespace terratact {

/// Notices that the robot has left the pose of a scene: it drives, or its pitch or flippers have changed.  Once
/// left it stays left.
class PoseWatch {
public:
    // Another pose beyond these; five standard deviations of an MTi's difference of two pitches.
    static constexpr double kPitchChange = 0.06;    ///< [rad]
    static constexpr double kFlipperChange = 0.05;  ///< [rad] of the mean of a pair

    explicit PoseWatch(const Measurement& scene) : scene_(proprioception(scene)) {}

    /// The newest telemetry, the count-th since the source was opened (1 for the first); the same may be looked at
    /// again.  Two that differ have to say so in a row: one outlier of the IMU ends nothing.
    void look(const Measurement& newest, std::uint64_t count);

    bool hasMoved() const { return moved_; }

private:
    bool differs(const Measurement& newest) const;

    Proprioception scene_;
    std::uint64_t suspectedAt_ = 0;  ///< count of the first that said so; 0: the newest does not
    bool moved_ = false;
};

}  // namespace terratact
