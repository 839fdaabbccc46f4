#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/bags/field_value.h"
#include "core/bags/message_schema.h"
#include "core/base/result.h"

namespace terratact {

/// A topic (or channel) of a recording with the definition of its messages.
struct RecordedTopic {
    std::string name{};            ///< "/imu/data"
    std::string type{};            ///< "sensor_msgs/Imu"
    std::string encoding{};        ///< of its messages: "ros1", "cdr", "json", "csv", …
    std::string schemaEncoding{};  ///< "ros1msg", "ros2msg", "jsonschema", …
    /// Definition of the messages, which several topics may share; null: the file has none.
    std::shared_ptr<const std::string> schema{};
    std::optional<std::uint64_t> messages{};  ///< their number, if the file's index says it
};

/// Decodes the messages of one topic by the definition in the file.
class MessageDecoder {
public:
    /// Errors state what was expected, without the topic: the encoding is unknown, or the definition is
    /// missing or cannot be parsed. A definition that is missing is replaced where the type is one of
    /// core/bags/known_messages.h.
    static Result<MessageDecoder> of(const RecordedTopic& topic);

    /// Errors state the cause, without the topic.
    Result<FieldValue> decode(std::string_view data) const;

private:
    enum class Encoding : std::uint8_t { Json, Ros1, Cdr };
    explicit MessageDecoder(Encoding encoding) : encoding_(encoding) {}

    Encoding encoding_;
    MessageSchema schema_;
};

}  // namespace terratact
