#include "core/log/rows/message_json.h"

#include <fmt/format.h>

#include <cstddef>

namespace terratact {
namespace {

constexpr int kDeepest = 8;
constexpr std::size_t kMaxArguments = 9;

void writeString(std::string& out, std::string_view text)
{
    out += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\')
            (out += '\\') += c;
        else if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
        else
            out += c;
    }
    out += '"';
}

void write(std::string& out, const Message& message)
{
    if (message.context.empty() && message.arguments.empty())
        return writeString(out, message.source);
    out += '[';
    writeString(out, message.context);
    out += ',';
    writeString(out, message.source);
    for (const Message& argument : message.arguments) {
        out += ',';
        write(out, argument);
    }
    out += ']';
}

/// Reads what write() writes. Returns false for anything else.
class JsonMessage {
public:
    explicit JsonMessage(std::string_view json) : rest_(json) {}

    bool read(Message& message, int depth = 0)
    {
        if (!consume('[')) return readString(message.source);
        if (depth >= kDeepest || !readString(message.context) || !consume(',')
            || !readString(message.source))
            return false;
        while (consume(',')) {
            if (message.arguments.size() == kMaxArguments) return false;
            if (!read(message.arguments.emplace_back(), depth + 1)) return false;
        }
        return consume(']');
    }
    bool atEnd() const { return rest_.empty(); }

private:
    bool consume(char wanted)
    {
        if (rest_.empty() || rest_.front() != wanted) return false;
        rest_.remove_prefix(1);
        return true;
    }
    bool readString(std::string& text)
    {
        if (!consume('"')) return false;
        while (!rest_.empty() && rest_.front() != '"')
            if (!readCharacter(text)) return false;
        return consume('"');
    }
    bool readCharacter(std::string& text)
    {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        if (c != '\\') {
            text += c;
            return true;
        }
        if (consume('"')) return text += '"', true;
        if (consume('\\')) return text += '\\', true;
        if (!consume('u') || rest_.size() < 4) return false;
        const auto code = integerFrom<unsigned>(rest_.substr(0, 4), 16);
        if (!code || *code >= 0x20) return false;
        rest_.remove_prefix(4);
        text += static_cast<char>(*code);
        return true;
    }

    std::string_view rest_;
};

}  // namespace

std::string jsonOf(const Message& message)
{
    std::string json;
    if (!message.empty()) write(json, message);
    return json;
}

std::optional<Message> messageFromJson(std::string_view json)
{
    Message message;
    if (json.empty()) return message;
    JsonMessage reader(json);
    if (!reader.read(message) || !reader.atEnd()) return std::nullopt;
    return message;
}

}  // namespace terratact
