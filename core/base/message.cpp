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

Message Message::listed(std::vector<Message> parts, std::string_view separator)
{
    constexpr std::size_t kMaxPlaces = 9;
    if (parts.empty()) return {};
    if (parts.size() == 1) return std::move(parts.front());
    if (parts.size() > kMaxPlaces) {
        const auto rest = parts.begin() + kMaxPlaces - 1;
        Message last = listed({rest, parts.end()}, separator);
        parts.erase(rest, parts.end());
        parts.push_back(std::move(last));
    }
    Message message;
    for (std::size_t place = 1; place <= parts.size(); ++place)
        message.source.append(place == 1 ? std::string_view() : separator)
            .append("%")
            .append(std::to_string(place));
    message.arguments = std::move(parts);
    return message;
}

Message Message::followedBy(Message first, std::string then)
{
    Message message;
    message.source = "%1 (%2)";
    message.arguments = {std::move(first), verbatim(std::move(then))};
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

Message messageOf(const std::exception& error)
{
    if (const auto* failure = dynamic_cast<const Failure*>(&error)) return failure->message();
    if (const auto* refused = dynamic_cast<const RefusedInput*>(&error)) return refused->message();
    return Message::verbatim(error.what());
}

std::string english(const std::vector<Message>& messages, std::string_view separator)
{
    std::string text;
    for (std::size_t i = 0; i < messages.size(); ++i)
        text.append(i == 0 ? std::string_view() : separator).append(messages[i].english());
    return text;
}

std::string fixed(double value, int decimals)
{
    return fmt::format("{:.{}f}", value, decimals);
}

std::string signedFixed(double value, int decimals)
{
    return fmt::format("{:+.{}f}", value, decimals);
}

Message withoutControls(Message message)
{
    std::ranges::replace_if(message.source, isControl, '?');
    for (Message& argument : message.arguments) argument = withoutControls(std::move(argument));
    return message;
}

}  // namespace terratact
