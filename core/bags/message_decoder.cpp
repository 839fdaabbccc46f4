#include "core/bags/message_decoder.h"

#include <fmt/format.h>

#include <utility>

#include "core/bags/json_value.h"
#include "core/bags/known_messages.h"
#include "core/bags/ros_message.h"
#include "core/base/text.h"

namespace terratact {
namespace {

/// Returns the error of a topic whose definition has another encoding than its messages need.
Error otherEncoding(const RecordedTopic& topic, std::string_view wanted)
{
    return Error(fmt::format("its definition has the encoding {}, expected {}; {}",
                             shown(topic.schemaEncoding), wanted,
                             topic.schemaEncoding == "ros2idl"
                                 ? "record it again where the .msg files of its package are "
                                   "installed"
                                 : "record or convert it with that"));
}

/// Returns the definition of a topic's messages: the file's own, else that of a common type.
Result<std::string_view> messageDefinition(const RecordedTopic& topic, std::string_view wanted)
{
    if (!topic.schema)
        return Error(topic.schema.error().text
                     + ". Record fewer types in one file, or a type with a shorter definition");
    if (const auto& own = *topic.schema; own && !own->empty()) {
        if (topic.schemaEncoding == wanted) return std::string_view(*own);
        return otherEncoding(topic, wanted);
    }
    if (topic.type.empty())
        return Error("the file holds no definition for it; record it again with a newer "
                     "program");
    if (const std::string_view common = knownDefinition(topic.type); !common.empty()) return common;
    if (!topic.schemaEncoding.empty()) return otherEncoding(topic, wanted);
    return Error(fmt::format("the file lacks the definition of {}; record it again "
                             "with a newer program, or as MCAP",
                             printable(topic.type)));
}

}  // namespace

std::string keptName(std::string_view name)
{
    if (name.size() <= kMaxTopicName) return std::string(name);
    return std::string(beginningOf(name, kMaxTopicName)) + "…";
}

Result<MessageDecoder> MessageDecoder::of(const RecordedTopic& topic)
{
    if (topic.encoding == "json") return MessageDecoder(Encoding::Json);
    const bool isRos1 = topic.encoding == "ros1";
    if (!isRos1 && topic.encoding != "cdr")
        return Error(fmt::format("its messages have the encoding {}, expected json, ros1 "
                                 "or cdr; record or convert it with one of these",
                                 shown(topic.encoding)));
    const auto text = messageDefinition(topic, isRos1 ? "ros1msg" : "ros2msg");
    if (!text) return text.error();
    auto schema = MessageSchema::parse(
        topic.type, *text, isRos1 ? MessageSchema::Dialect::Ros1 : MessageSchema::Dialect::Ros2);
    if (!schema) return schema.error();
    MessageDecoder decoder(isRos1 ? Encoding::Ros1 : Encoding::Cdr);
    decoder.schema_ = std::move(*schema);
    return decoder;
}

Result<FieldValue> MessageDecoder::decode(std::string_view data) const
{
    switch (encoding_) {
    case Encoding::Json: return jsonValue(data);
    case Encoding::Ros1: return decodeRos1(schema_, data);
    case Encoding::Cdr: return decodeCdr(schema_, data);
    }
    return Error{"has an unknown encoding"};
}

std::size_t MessageDecoder::parts() const
{
    std::size_t count = schema_.structs.size();
    for (const MessageSchema::Struct& of : schema_.structs) count += of.fields.size();
    return count;
}

}  // namespace terratact
