#include "core/base/message.h"

#include <fmt/format.h>

#include <algorithm>
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

Message withoutControls(Message message)
{
    std::ranges::replace_if(message.source, isControl, '?');
    for (Message& argument : message.arguments) argument = withoutControls(std::move(argument));
    return message;
}

}  // namespace terratact
