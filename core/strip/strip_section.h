#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "core/base/message.h"
#include "core/strip/pose_covariance.h"
#include "core/strip/strip_bins.h"

namespace terratact {

/// Reason why a section of the strip begins, separate from the ground before.
enum class SectionStart : std::uint8_t {
    First,         ///< nothing was felt before
    Turned,        ///< the robot turned too tightly
    TelemetryGap,  ///< telemetry was silent for too long
    NoOdometry,    ///< the robot reported no odometry
    OdometryJump,  ///< the reported way jumped, for example because the robot restarted
    Suspected,     ///< the sensor watch suspected the odometry or the pitch
    Cleared,       ///< the operator cleared the strip, or another model was loaded
};
inline constexpr std::array kSectionStarts{SectionStart::First,        SectionStart::Turned,
                                           SectionStart::TelemetryGap, SectionStart::NoOdometry,
                                           SectionStart::OdometryJump, SectionStart::Suspected,
                                           SectionStart::Cleared};

/// Returns "first", "turned", "telemetry gap", "no odometry", "odometry jump", "suspected" or "cleared".
std::string_view name(SectionStart start);
/// Returns a sentence such as "the robot has turned".
SourceText describe(SectionStart start);

/// Left and right bin of one column; empty: no estimate covers it.
using StripColumn = std::array<std::optional<StripBin>, 2>;

/// A pose along the way, in the frame of its segment.
struct WayPose {
    Vec2 imu{};                       ///< [m] x along the way, z up
    double planX = 0.0, planY = 0.0;  ///< [m] the IMU from above
    double heading = 0.0;             ///< [rad] left positive, not wrapped
    double way = 0.0;                 ///< [m] way rolled since the begin of the segment
    PoseCovariance drift{};           ///< error since the begin of the segment
    bool operator==(const WayPose&) const = default;
};

/// A stretch of the way without a break. Its frame begins at the IMU of its first scene: x forward along the way, z up
/// along gravity [m].
struct StripSection {
    SectionStart why = SectionStart::First;
    std::int64_t segment = 0;  ///< number of the stretch without a break
    WayPose start{};           ///< pose of its first scene
    std::map<int, StripColumn> columns{};

    /// Returns the IMU at a pose, in the section's frame [m].
    Vec2 imuAt(const WayPose& pose) const
    {
        return {pose.imu.x - start.imu.x, pose.imu.z - start.imu.z};
    }
};

}  // namespace terratact
