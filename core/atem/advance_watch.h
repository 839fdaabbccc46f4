#pragma once

#include <cstdint>

#include "core/robot/measurement.h"

namespace terratact {

/// Compares an advance with the odometry: the robot must drive, halt, and have moved as far as
/// commanded. Readings must be younger than the command.
class AdvanceWatch {
public:
    /// Excess of the odometry over the commanded distance [m] that counts as running on. The tracks
    /// may slip by 30 % of the longest advance.
    static constexpr double kOverrun = 0.05;
    static constexpr double kMinShare = 0.5;  ///< a shorter share of the distance is no advance
    static constexpr double kStarts = 0.005;  ///< [m] the robot has begun to move

    enum class Result : std::uint8_t {
        Running,
        Advanced,   ///< the robot has moved and stands still
        NotMoved,   ///< it stands still too early
        RanOn,      ///< it has moved further than commanded
        NoOdometry  ///< the odometry is missing
    };

    /// before: telemetry at the command. distance: commanded, [m] > 0.
    AdvanceWatch(const Measurement& before, double distance);

    Result poll(const Measurement& m);

    double way() const { return way_; }  ///< [m] way of the tracks since the command

private:
    bool known_;
    double begin_, distance_;
    double way_ = 0.0;
    bool driven_ = false;
};

}  // namespace terratact
