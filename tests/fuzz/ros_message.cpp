// Fuzzes message definitions and the bytes of messages: a definition, a zero byte, and the message. What is decoded is
// bounded by the number of its bytes, or by the limits of FieldValue.
#include "core/bags/ros_message.h"

#include <cstdint>

#include "core/bags/json_value.h"
#include "tests/fuzz/promise.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

std::size_t valuesIn(const FieldValue& value)
{
    std::size_t count = 1;
    for (const FieldValue& part : value.parts) count += valuesIn(part);
    return count;
}

void promiseBounded(const Result<FieldValue>& value)
{
    if (value)
        promise(valuesIn(*value) <= 3 * FieldValue::kMaxValues, "a message has bounded values");
    else
        promise(!value.error().text.empty(), "a refusal has a cause");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text = textOf(data, size);
    const std::size_t end = std::min(text.find('\0'), text.size());
    const std::string bytes = text.substr(std::min(end + 1, text.size()));
    for (const auto dialect : {MessageSchema::Dialect::Ros1, MessageSchema::Dialect::Ros2}) {
        const auto schema = MessageSchema::parse("p/T", text.substr(0, end), dialect);
        if (!schema) continue;
        promise(schema->structs.size() <= MessageSchema::kMaxStructs + MessageSchema::kMaxFields,
                "a definition has bounded parts");
        promiseBounded(dialect == MessageSchema::Dialect::Ros1 ? decodeRos1(*schema, bytes)
                                                               : decodeCdr(*schema, bytes));
    }
    promiseBounded(jsonValue(text));
    return 0;
}
