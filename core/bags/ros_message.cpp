#include "core/bags/ros_message.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/bags/byte_cursor.h"
#include "core/base/text.h"

namespace terratact {
namespace {

using RosField = MessageSchema::Field;

/// Layout of the bytes: how members are aligned, and how a text ends.
struct RosLayout {
    bool isCdr = false;
    std::size_t mostAlignment = 1;  ///< [bytes]
};

std::size_t sizeOf(FieldType type)
{
    switch (type) {
    case FieldType::Bool:
    case FieldType::Int8:
    case FieldType::UInt8: return 1;
    case FieldType::Int16:
    case FieldType::UInt16: return 2;
    case FieldType::Int32:
    case FieldType::UInt32:
    case FieldType::Float32: return 4;
    case FieldType::Int64:
    case FieldType::UInt64:
    case FieldType::Float64: return 8;
    default: return 0;
    }
}

class RosDecoder {
public:
    RosDecoder(const MessageSchema& schema, std::string_view data, RosLayout layout, bool bigEndian)
        : schema_(schema), cursor_(data, bigEndian), layout_(layout),
          stepsLeft_(data.size() + FieldValue::kMaxElements)
    {
    }

    Result<FieldValue> decode(std::size_t mostBehind)
    {
        FieldValue message;
        if (!readStruct(0, message, 0)) return Error{why_};
        if (cursor_.left() > mostBehind)
            return Error{fmt::format("has {} bytes behind its last member; its definition is of "
                                     "another message",
                                     cursor_.left())};
        return message;
    }

private:
    bool refuse(const RosField& field, std::string_view cause)
    {
        if (why_.empty())
            why_ = fmt::format("member {} at byte {} {}", shown(field.name), cursor_.at(), cause);
        return false;
    }

    bool ends(const RosField& field)
    {
        return refuse(field,
                      "goes beyond the message's end; the message is cut, or its definition is "
                      "of another message");
    }

    void align(std::size_t size)
    {
        const std::size_t to = std::min(size, layout_.mostAlignment);
        if (to > 1 && cursor_.at() % to != 0) cursor_.bytes(to - cursor_.at() % to);
    }

    bool readStruct(std::size_t index, FieldValue& into, int depth)
    {
        const MessageSchema::Struct& type = schema_.structs[index];
        into.kind = FieldValue::Kind::Members;
        into.parts.reserve(type.fields.size());
        for (const RosField& field : type.fields) {
            if (depth >= FieldValue::kDeepest) return refuse(field, "nests too deep");
            if (++values_ > FieldValue::kMaxValues)
                return refuse(field, fmt::format("is beyond the {} values of one message",
                                                 FieldValue::kMaxValues));
            FieldValue& part = into.parts.emplace_back();
            part.name = field.name;
            if (!readField(field, part, depth)) return false;
        }
        // A message without members is one byte in CDR.
        if (type.fields.empty() && layout_.isCdr) cursor_.bytes(1);
        return true;
    }

    bool readField(const RosField& field, FieldValue& into, int depth)
    {
        if (field.array == MessageSchema::Array::None) return readOne(field, into, depth);
        std::uint32_t count = field.count;
        if (field.array == MessageSchema::Array::Counted) {
            align(4);
            count = cursor_.number<std::uint32_t>();
            if (!cursor_.isValid()) return ends(field);
        }
        if (const std::size_t size = sizeOf(field.type); size > 0)
            return readNumbers(field, count, size, into);
        return readItems(field, count, into, depth);
    }

    bool readNumbers(const RosField& field, std::uint32_t count, std::size_t size, FieldValue& into)
    {
        into.kind = FieldValue::Kind::Numbers;
        if (count == 0) return true;
        align(size);
        if (std::uint64_t{count} * size > cursor_.left()) return ends(field);
        const std::size_t kept = std::min<std::size_t>(count, FieldValue::kMaxElements);
        into.numbers.reserve(kept);
        for (std::size_t i = 0; i < kept; ++i) into.numbers.push_back(number(field.type));
        cursor_.bytes(std::uint64_t{count - kept} * size);
        return true;
    }

    /// Reads an array of texts, times or messages.
    bool readItems(const RosField& field, std::uint32_t count, FieldValue& into, int depth)
    {
        const bool isText = field.type == FieldType::Text || field.type == FieldType::WideText;
        into.kind = isText ? FieldValue::Kind::Texts : FieldValue::Kind::Items;
        for (std::uint32_t i = 0; i < count; ++i) {
            // An element may have no bytes, so that only this bounds the time.
            if (stepsLeft_ == 0) return refuse(field, "declares more elements than it has bytes");
            --stepsLeft_;
            FieldValue item;
            if (!readOne(field, item, depth)) return false;
            if (i >= FieldValue::kMaxElements) continue;
            if (isText)
                into.texts.push_back(std::move(item.text));
            else
                into.parts.push_back(std::move(item));
        }
        return true;
    }

    bool readOne(const RosField& field, FieldValue& into, int depth)
    {
        switch (field.type) {
        case FieldType::Struct: return readStruct(field.ofStruct, into, depth + 1);
        case FieldType::Text:
        case FieldType::WideText: return readText(field, into);
        case FieldType::Time:
        case FieldType::Duration: return readTime(field, into);
        default:
            align(sizeOf(field.type));
            into = named(std::move(into.name), FieldValue::of(number(field.type)));
            return cursor_.isValid() || ends(field);
        }
    }

    static FieldValue named(std::string name, FieldValue value)
    {
        value.name = std::move(name);
        return value;
    }

    bool readText(const RosField& field, FieldValue& into)
    {
        align(4);
        const auto length = cursor_.number<std::uint32_t>();
        const std::uint64_t unit = field.type == FieldType::WideText ? 2 : 1;
        std::string_view text = cursor_.bytes(length * unit);
        if (!cursor_.isValid()) return ends(field);
        if (layout_.isCdr && text.ends_with('\0')) text.remove_suffix(1);
        into.kind = FieldValue::Kind::Text;
        into.text = std::string(text.substr(0, kMaxText));
        return true;
    }

    bool readTime(const RosField& field, FieldValue& into)
    {
        const bool isSigned = field.type == FieldType::Duration;
        into.kind = FieldValue::Kind::Members;
        into.parts.reserve(2);
        for (const char* const part : {"sec", "nsec"})
            into.parts.push_back(named(
                part, FieldValue::of(number(isSigned ? FieldType::Int32 : FieldType::UInt32))));
        return cursor_.isValid() || ends(field);
    }

    double number(FieldType type)
    {
        switch (type) {
        case FieldType::Int8: return cursor_.number<std::int8_t>();
        case FieldType::Bool:
        case FieldType::UInt8: return cursor_.number<std::uint8_t>();
        case FieldType::Int16: return cursor_.number<std::int16_t>();
        case FieldType::UInt16: return cursor_.number<std::uint16_t>();
        case FieldType::Int32: return cursor_.number<std::int32_t>();
        case FieldType::UInt32: return cursor_.number<std::uint32_t>();
        case FieldType::Int64: return static_cast<double>(cursor_.number<std::int64_t>());
        case FieldType::UInt64: return static_cast<double>(cursor_.number<std::uint64_t>());
        case FieldType::Float32: return static_cast<double>(cursor_.number<float>());
        default: return cursor_.number<double>();
        }
    }

    static constexpr std::size_t kMaxText = 4096;  ///< kept bytes of a text

    const MessageSchema& schema_;
    ByteCursor cursor_;
    RosLayout layout_;
    std::size_t stepsLeft_;
    std::size_t values_ = 0;
    std::string why_;
};

}  // namespace

Result<FieldValue> decodeRos1(const MessageSchema& schema, std::string_view data)
{
    return RosDecoder(schema, data, {}, false).decode(0);
}

Result<FieldValue> decodeCdr(const MessageSchema& schema, std::string_view data)
{
    constexpr std::size_t kHeader = 4;
    if (data.size() < kHeader)
        return Error{
            fmt::format("has {} bytes, expected the 4 bytes of a CDR header", data.size())};
    // OMG DDS-XTypes 1.3, table 60: 0 and 1 are CDR, 6 and 7 are CDR 2; odd ones are little-endian.
    const auto kind = static_cast<unsigned>(static_cast<unsigned char>(data[0])) << 8U
                    | static_cast<unsigned char>(data[1]);
    if (kind > 1 && kind != 6 && kind != 7)
        return Error{
            fmt::format("has the CDR representation {}, expected plain CDR (0, 1, 6 or 7)", kind)};
    const RosLayout layout{.isCdr = true, .mostAlignment = kind > 1 ? 4U : 8U};
    return RosDecoder(schema, data.substr(kHeader), layout, kind % 2 == 0).decode(7);
}

}  // namespace terratact
