#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bags/message_decoder.h"
#include "core/base/result.h"
#include "core/clouds/cloud_reader.h"

namespace terratact {

/// Points of a message sensor_msgs/PointCloud2.
struct CloudMessage {
    double stamp = 0.0;   ///< [s] of its header
    std::string frame{};  ///< of its header: the sensor's
    std::vector<CloudPoint> points{};
    std::uint64_t leftOut = 0;  ///< not finite, or farther than kFarthestPoint
};

/// Decodes a message of this topic: ROS 1, or CDR of ROS 2. Errors state the cause: another encoding, no x, y or z, or
/// sizes that do not agree with the data.
Result<CloudMessage> cloudMessage(const RecordedTopic& topic, std::string_view data);

/// What was read from a recording.
struct CloudMessages {
    std::uint64_t clouds = 0, points = 0, leftOut = 0;
    std::vector<std::string> remarks{};
};

/// Reads the clouds of a topic in a recording, one message at a time. Calls `add` with the message,
/// whose stamp is the recorder's time if it was 0. It returns false to end the reading. Errors name
/// the file, the topic and the message. Causes: no such topic; a type that is not PointCloud2; a
/// message that cannot be decoded.
Result<CloudMessages> readCloudMessages(const std::string& path, const std::string& topic,
                                        const std::function<bool(const CloudMessage& cloud)>& add);

}  // namespace terratact
