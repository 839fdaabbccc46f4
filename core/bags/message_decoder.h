#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/bags/field_value.h"
#include "core/bags/message_schema.h"
#include "core/base/result.h"

namespace terratact {

/// Longest name, type or encoding of a topic [bytes], as in ROS 2.
inline constexpr std::size_t kMaxTopicName = 255;

/// Returns a name, type or encoding of a file, cut after kMaxTopicName bytes with "…": many channels and
/// errors repeat it.
std::string keptName(std::string_view name);

/// A topic (or channel) of a recording with the definition of its messages. keptName() cuts its texts.
struct RecordedTopic {
    std::string name{};            ///< "/imu/data"
    std::string type{};            ///< "sensor_msgs/Imu"
    std::string encoding{};        ///< of its messages: "ros1", "cdr", "json", "csv", …
    std::string schemaEncoding{};  ///< "ros1msg", "ros2msg", "jsonschema", …; empty: no definition
    /// Definition of the messages, which several topics may share. Null or empty: the file has none, or
    /// has it in an encoding that is not read. Error: why the file's own one is left out.
    Result<std::shared_ptr<const std::string>> schema = std::shared_ptr<const std::string>();
    std::optional<std::uint64_t> messages{};  ///< their number, if the file's index says it
};

/// Decodes the messages of one topic by the definition in the file.
class MessageDecoder {
public:
    /// Errors state what was expected, without the topic: the encoding is unknown, or the definition is
    /// missing, left out or cannot be parsed. A definition that the file lacks is
    /// replaced if its type is in core/bags/known_messages.h. So is one in an encoding that is not read. One
    /// that is left out is not replaced.
    static Result<MessageDecoder> of(const RecordedTopic& topic);

    /// Errors state the cause, without the topic.
    Result<FieldValue> decode(std::string_view data) const;

    /// Returns the number of structs and fields of the definition; 0 for JSON.
    std::size_t parts() const;

private:
    enum class Encoding : std::uint8_t { Json, Ros1, Cdr };
    explicit MessageDecoder(Encoding encoding) : encoding_(encoding) {}

    Encoding encoding_;
    MessageSchema schema_;
};

}  // namespace terratact
