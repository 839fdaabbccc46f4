#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/bags/recording.h"
#include "core/base/result.h"
#include "core/mapping/frame_pose.h"
#include "core/mapping/mapping.h"

namespace terratact {

/// Pose of a frame in the cloud's frame, which has z up.
using CloudPose = FramePose;

/// Reads "x y z roll pitch yaw" in m and degrees. It turns about z, then y, then x, like ROS (REP 103).
/// Empty unless the text is six finite numbers.
std::optional<CloudPose> mountFrom(std::string_view text);

/// Limits of poses that are one drive.
struct PoseLimits {
    double maxSpeed = 5.0;  ///< [m/s] between two poses; a faster one jumps
    double maxGap = 0.5;    ///< [s] longest time between two poses in which one is interpolated
};

/// Poses of one drive in the order of time.
class PoseTrack {
public:
    struct Entry {
        double time = 0.0;  ///< [s]
        CloudPose pose{};
    };

    /// Throws std::invalid_argument unless there is an entry and times rise.
    PoseTrack(std::vector<Entry> entries, double maxGap);

    double begin() const { return entries_.front().time; }
    double end() const { return entries_.back().time; }
    std::size_t size() const { return entries_.size(); }
    const std::vector<Entry>& entries() const { return entries_; }

    /// Returns the pose at a time: that of an entry at most 1 ms away. Else it is interpolated between
    /// two entries that are at most maxGap apart. Empty elsewhere.
    std::optional<CloudPose> at(double time) const;

private:
    std::vector<Entry> entries_;
    double maxGap_;
};

/// Tracks by the name of their run; "" for a file without runs.
using PoseTracks = std::map<std::string, PoseTrack>;

/// Reads poses:
///   TUM   lines "time x y z qx qy qz qw", separated by blanks; lines with # are comments
///   CSV   columns time (t_s, time, timestamp, t or stamp, in s), x, y, z (or x_m …), qx, qy, qz, qw;
///         and, for several drives in one file, run
/// Errors name the file, the line, what was expected and what to do. Causes besides format: a time that does not rise;
/// a quaternion whose length is not 1; a jump faster than PoseLimits::maxSpeed and longer than 0.3 m.
Result<PoseTracks> readPoses(const std::string& path, const PoseLimits& limits);

/// Reads the poses of the topic that the mapping names under [odometry]. From transforms, it reads
/// the poses of base_frame in its frame. Times are those of the recorder, or of header.stamp if the
/// mapping says so [s]. Errors are as above.
Result<PoseTracks> readPoses(Recording& recording, const Mapping& mapping,
                             const PoseLimits& limits);

}  // namespace terratact
