#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace terratact {

/// Type of a field of a ROS message.
enum class FieldType : std::uint8_t {
    Bool,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float32,
    Float64,
    Text,
    WideText,
    Time,      ///< ROS 1: two numbers of 32 bits, unsigned
    Duration,  ///< ROS 1: two numbers of 32 bits, signed
    Struct,
};

/// Definition of a message with all messages in it, as a recording stores it.
struct MessageSchema {
    enum class Dialect : std::uint8_t { Ros1, Ros2 };
    enum class Array : std::uint8_t { None, Fixed, Counted };

    struct Field {
        std::string name;
        FieldType type = FieldType::UInt8;
        std::size_t ofStruct = 0;  ///< index into structs, if the type is Struct
        Array array = Array::None;
        std::uint32_t count = 0;  ///< elements of a fixed array
    };
    struct Struct {
        std::string name;  ///< "package/Type"
        std::vector<Field> fields;
    };

    std::vector<Struct> structs;  ///< the first is the message
    Dialect dialect = Dialect::Ros1;

    static constexpr std::size_t kMaxText = std::size_t{1} << 20U;  ///< bytes
    static constexpr std::size_t kMaxStructs = 1000, kMaxFields = 10'000;

    /// Parses the text of a message definition: schema encoding ros1msg or ros2msg, with the definitions
    /// of its parts behind lines of "=". type: of the message, "sensor_msgs/JointState". Errors name the
    /// type, the line and what was expected.
    static Result<MessageSchema> parse(std::string_view type, std::string_view text,
                                       Dialect dialect);
};

}  // namespace terratact
