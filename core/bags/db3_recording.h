#pragma once

#include <memory>
#include <string>

#include "core/bags/recording.h"

namespace terratact {

/// Opens a ROS 2 bag as rosbag2 stores it in SQLite (*.db3), with its journal if its recorder died.
/// Definitions come from the table message_definitions, which newer writers fill. Where it has none that
/// is read, the common types of core/bags/known_messages.h are known. A damaged file is read up to the
/// damage, and a remark says so. Messages of more than kMaxChunkBytes are an error of SQLite. Errors name
/// the file. Causes: it is no SQLite file, lacks the tables topics and messages, or is a recorded session of
/// this program.
Result<std::unique_ptr<Recording>> openDb3(const std::string& path);

}  // namespace terratact
