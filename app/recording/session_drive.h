#pragma once

#include <cstddef>
#include <cstdint>
#include <set>

#include "core/base/result.h"
#include "core/learn/data/drive_lines.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// The drive of a session, for the method trail, which remembers the way.
struct SessionDrive {
    DriveLines drive;
    std::size_t scenes = 0;
    std::size_t leftOut = 0;  ///< lines and scenes beyond the ranges of a file of drives
};

/// Returns a session's telemetry and scenes in the order of time (core/learn/data/drive_file.h). A telemetry line is
/// kept if it differs enough from the last kept line. Enough is 1 cm of way, 0.005 rad of pitch or heading, or 0.5 s.
/// onePlane: both sides get their mean, and the roll is left out. Heights are those that the session's source recorded.
/// repeated: ids of scenes to leave out. Errors name the file: its robot reports no odometry, or it has no other scene.
Result<SessionDrive> sessionDrive(SessionReader& session, const RobotModel& robot, bool onePlane,
                                  const std::set<std::int64_t>& repeated);

}  // namespace terratact
