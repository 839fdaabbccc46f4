#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/bags/recording.h"

namespace terratact {

inline constexpr std::string_view kBagMagic = "#ROSBAG V";

/// Opens a ROS 1 bag of version 2.0: chunks without compression, with bz2 or lz4. A valid index names all
/// topics and their chunks, and chunks without a selected topic are then not read. Without one, the file
/// is read from its beginning, as far as it goes. A chunk that cannot be decompressed, or is larger than
/// kMaxChunkBytes, is left out with a remark. Errors name the file: it cannot be read, has another
/// version, or is encrypted.
Result<std::unique_ptr<Recording>> openBag(const std::string& path);

}  // namespace terratact
