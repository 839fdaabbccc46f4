#include "core/bags/message_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "core/base/text.h"

namespace terratact {
namespace {

using SchemaDialect = MessageSchema::Dialect;

constexpr std::array<std::pair<std::string_view, FieldType>, 18> kPlainTypes{{
    {"bool", FieldType::Bool},
    {"byte", FieldType::UInt8},
    {"char", FieldType::UInt8},
    {"int8", FieldType::Int8},
    {"uint8", FieldType::UInt8},
    {"int16", FieldType::Int16},
    {"uint16", FieldType::UInt16},
    {"int32", FieldType::Int32},
    {"uint32", FieldType::UInt32},
    {"int64", FieldType::Int64},
    {"uint64", FieldType::UInt64},
    {"float32", FieldType::Float32},
    {"float64", FieldType::Float64},
    {"float", FieldType::Float32},
    {"double", FieldType::Float64},
    {"string", FieldType::Text},
    {"wstring", FieldType::WideText},
    {"octet", FieldType::UInt8},
}};

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Returns "package/Type" of "package/msg/Type".
std::string schemaName(std::string_view type)
{
    std::string name(type);
    if (const auto middle = name.find("/msg/"); middle != std::string::npos) name.erase(middle, 4);
    return name;
}

std::string packageOf(std::string_view name)
{
    return std::string(name.substr(0, name.find('/')));
}

bool isSeparatorLine(std::string_view line)
{
    return line.size() >= 3 && line.find_first_not_of('=') == std::string_view::npos;
}

/// The lines of one definition.
struct Definition {
    int line = 1;  ///< of the schema's text
    std::string_view text;
};

class SchemaParser {
public:
    SchemaParser(std::string_view type, SchemaDialect dialect)
        : type_(schemaName(type)), dialect_(dialect)
    {
    }

    Result<MessageSchema> parse(std::string_view text)
    {
        split(text);
        schema_.dialect = dialect_;
        if (const auto root = indexOf(type_); !root) return refused(0, "names no message type");
        // indexOf() adds what a definition refers to, until every reference is known.
        for (std::size_t i = 0; i < schema_.structs.size(); ++i)
            if (Status read = readStruct(i); !read) return read.error();
        return std::move(schema_);
    }

private:
    Error refused(int line, std::string_view cause) const
    {
        const std::string at = line > 0 ? fmt::format(", line {}", line) : std::string();
        return Error{fmt::format("the definition of {}{} {}", printable(type_), at, cause)};
    }

    void split(std::string_view text)
    {
        std::string name = type_;
        int line = 1;
        std::size_t begin = 0, at = 0;
        int beginLine = 1;
        while (at <= text.size() && definitions_.size() < MessageSchema::kMaxStructs) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            if (isSeparatorLine(trimmed(text.substr(at, end - at)))) {
                // Some writers begin the message itself with such a line, too.
                const std::string_view part = text.substr(begin, at - begin);
                const bool isNothing =
                    begin == 0 && part.find_first_not_of(" \t\r\n") == std::string_view::npos;
                if (!isNothing) definitions_.try_emplace(name, Definition{beginLine, part});
                at = std::min(end + 1, text.size());
                const std::size_t next = std::min(text.find('\n', at), text.size());
                std::string_view head = trimmed(text.substr(at, next - at));
                if (head.starts_with("MSG:")) head.remove_prefix(4);
                name = schemaName(trimmed(head));
                ++line;
                begin = std::min(next + 1, text.size());
                beginLine = line + 1;
                at = next + 1;
            } else {
                at = end + 1;
            }
            ++line;
        }
        definitions_.try_emplace(name, Definition{beginLine, text.substr(begin)});
    }

    /// Returns the place of a type among the structs; adds it there.
    std::optional<std::size_t> indexOf(const std::string& name)
    {
        if (const auto known = indexes_.find(name); known != indexes_.end()) return known->second;
        if (!definitions_.contains(name) && !isTime(name)) return std::nullopt;
        indexes_[name] = schema_.structs.size();
        schema_.structs.push_back({name, {}});
        return schema_.structs.size() - 1;
    }

    static bool isTime(std::string_view name)
    {
        return name == "builtin_interfaces/Time" || name == "builtin_interfaces/Duration";
    }

    std::optional<std::size_t> structNamed(std::string_view type, const std::string& package)
    {
        const std::string name = schemaName(type);
        if (name.find('/') != std::string::npos) return indexOf(name);
        if (name == "Header")
            if (const auto header = indexOf("std_msgs/Header")) return header;
        if (const auto own = indexOf(package + '/' + name)) return own;
        const std::string ending = '/' + name;
        for (const auto& [known, definition] : definitions_)
            if (known.ends_with(ending)) return indexOf(known);
        return std::nullopt;
    }

    Status readStruct(std::size_t index)
    {
        if (schema_.structs.size() > MessageSchema::kMaxStructs)
            return refused(0, fmt::format("has more than {} parts", MessageSchema::kMaxStructs));
        const std::string name = schema_.structs[index].name;
        const auto found = definitions_.find(name);
        if (found == definitions_.end()) {  // a time of ROS 2, which some writers leave out
            schema_.structs[index].fields = {{.name = "sec", .type = FieldType::Int32},
                                             {.name = "nanosec", .type = FieldType::UInt32}};
            return Done{};
        }
        int line = found->second.line;
        std::string_view rest = found->second.text;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            if (Status read = readLine(index, packageOf(name), rest.substr(0, end), line); !read)
                return read;
            rest.remove_prefix(std::min(end + 1, rest.size()));
            ++line;
        }
        return Done{};
    }

    Status readLine(std::size_t index, const std::string& package, std::string_view text, int line)
    {
        text = trimmed(text.substr(0, text.find('#')));
        if (text.empty()) return Done{};
        const std::size_t typeEnd = text.find_first_of(" \t");
        if (typeEnd == std::string_view::npos)
            return refused(line, "is not \"TYPE NAME\": " + shown(text));
        std::string_view name = trimmed(text.substr(typeEnd));
        const std::size_t nameEnd = name.find_first_of(" \t=");
        const bool isConstant =
            nameEnd != std::string_view::npos && trimmed(name.substr(nameEnd)).starts_with('=');
        if (isConstant) return Done{};
        name = name.substr(0, nameEnd);
        if (++fields_ > MessageSchema::kMaxFields)
            return refused(line, fmt::format("has more than {} fields", MessageSchema::kMaxFields));
        auto field = fieldOf(text.substr(0, typeEnd), package);
        if (!field)
            return refused(line,
                           "has a field of an unknown type: " + shown(text.substr(0, typeEnd)));
        field->name = std::string(name);
        schema_.structs[index].fields.push_back(std::move(*field));
        return Done{};
    }

    std::optional<MessageSchema::Field> fieldOf(std::string_view type, const std::string& package)
    {
        MessageSchema::Field field;
        if (type.ends_with(']')) {
            const std::size_t open = type.rfind('[');
            if (open == std::string_view::npos) return std::nullopt;
            const std::string_view size = type.substr(open + 1, type.size() - open - 2);
            field.array = MessageSchema::Array::Counted;
            if (!size.empty() && !size.starts_with("<=")) {
                const auto count = integerFrom<std::uint32_t>(size);
                if (!count) return std::nullopt;
                field.array = MessageSchema::Array::Fixed;
                field.count = *count;
            }
            type = type.substr(0, open);
        }
        if (const auto bound = type.find("<="); bound != std::string_view::npos)
            type = type.substr(0, bound);  // string<=10
        const auto* const plain =
            std::ranges::find(kPlainTypes, type, &std::pair<std::string_view, FieldType>::first);
        const bool isRos1 = dialect_ == SchemaDialect::Ros1;
        if (plain != kPlainTypes.end())
            field.type = plain->second;
        else if (isRos1 && type == "time")
            field.type = FieldType::Time;
        else if (isRos1 && type == "duration")
            field.type = FieldType::Duration;
        else if (!isRos1 && (type == "time" || type == "duration"))
            return structField(std::move(field), "builtin_interfaces/Time", package);
        else
            return structField(std::move(field), type, package);
        return field;
    }

    std::optional<MessageSchema::Field>
    structField(MessageSchema::Field field, std::string_view type, const std::string& package)
    {
        const auto index = structNamed(type, package);
        if (!index) return std::nullopt;
        field.type = FieldType::Struct;
        field.ofStruct = *index;
        return field;
    }

    std::string type_;
    SchemaDialect dialect_;
    std::map<std::string, Definition> definitions_;
    std::map<std::string, std::size_t> indexes_;
    std::size_t fields_ = 0;
    MessageSchema schema_;
};

}  // namespace

Result<MessageSchema> MessageSchema::parse(std::string_view type, std::string_view text,
                                           Dialect dialect)
{
    if (text.size() > kMaxText)
        return Error{
            fmt::format("the definition of {} is larger than {} bytes", printable(type), kMaxText)};
    return SchemaParser(type, dialect).parse(text);
}

}  // namespace terratact
