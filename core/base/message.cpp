#include "core/base/message.h"

#include <fmt/format.h>

#include <utility>

namespace terratact {

Message Message::verbatim(std::string text)
{
    Message message;
    message.source = std::move(text);
    return message;
}

Message Message::joined(Message first, Message then)
{
    Message message;
    message.source = "%1: %2";
    message.arguments = {std::move(first), std::move(then)};
    return message;
}

std::string Message::english() const
{
    if (arguments.empty()) return source;
    return filled(source, [this](std::size_t place) {
        return place <= arguments.size() ? arguments[place - 1].english() : std::string();
    });
}

bool Message::operator==(const Message& other) const
{
    return context == other.context && source == other.source && arguments == other.arguments;
}

std::string fixed(double value, int decimals)
{
    return fmt::format("{:.{}f}", value, decimals);
}

std::string format_as(const Message& message)
{
    return message.english();
}

}  // namespace terratact
