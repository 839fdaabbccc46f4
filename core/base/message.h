#pragma once

#include <concepts>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/text.h"

namespace terratact {

/// English sentence of the source, with %1 … %9 for its arguments, and its context for translators.
/// It points to literals.
struct SourceText {
    const char* context = "";
    const char* english = "";  ///< empty: no message
};

/// Marks a sentence for the translators; resources/translations/update.sh finds it.
#define TR_NOOP(context, english) (terratact::SourceText{context, english})

/// Message to the operator: a sentence and its arguments, formatted where it is shown. core formats
/// it in English (english()). The console translates the source text (app/display/translated.h). An
/// argument is a message too. A number or a name has no context and is not translated.
struct Message {
    Message() = default;
    Message(SourceText text) : context(text.context), source(text.english) {}
    template <class... Arguments>
    requires(sizeof...(Arguments) > 0) Message(SourceText text, const Arguments&... given)
        : Message(text)
    {
        arguments.reserve(sizeof...(given));
        (arguments.push_back(argument(given)), ...);
    }

    /// Returns a message that is not translated: a name, a number, or the output of another
    /// program.
    static Message verbatim(std::string text);

    /// Returns "first: then".
    static Message joined(Message first, Message then);

    /// Returns "first; second; third"; an empty message of no parts. separator: without '%'.
    static Message listed(std::vector<Message> parts, std::string_view separator);

    /// Returns "first (then)".
    static Message followedBy(Message first, std::string then);

    bool empty() const { return source.empty(); }

    /// Returns the sentence with its arguments inserted.
    std::string english() const;

    bool operator==(const Message& other) const;

    std::string context{};  ///< empty: the source is not translated
    std::string source{};   ///< %1 … %9 only count where there are arguments
    std::vector<Message> arguments{};

private:
    static Message argument(const Message& message) { return message; }
    static Message argument(SourceText text) { return text; }
    static Message argument(double value) { return verbatim(numberText(value)); }
    template <std::integral Integer>
    static Message argument(Integer value)
    {
        static_assert(!std::is_same_v<Integer, bool> && !std::is_same_v<Integer, char>);
        return verbatim(std::to_string(value));
    }
    template <class Text>
    requires std::convertible_to<const Text&, std::string_view>
    static Message argument(const Text& text)
    {
        return verbatim(std::string(std::string_view(text)));
    }
};

/// Exception with a message to the operator. what() is the message in English.
template <class Exception>
class WithMessage : public Exception {
public:
    explicit WithMessage(Message message)
        : Exception(message.english()), message_(std::move(message))
    {
    }
    const Message& message() const { return message_; }

private:
    Message message_;
};

/// Exception for a condition outside of the program.
class Failure : public WithMessage<std::runtime_error> {
public:
    using WithMessage::WithMessage;
};

/// Exception for an input without a result; it is an argument of the caller, too.
class RefusedInput : public WithMessage<std::invalid_argument> {
public:
    using WithMessage::WithMessage;
};

/// Returns the message of a Failure or a RefusedInput; what() of another exception.
Message messageOf(const std::exception& error);

/// Returns the messages in English, with the separator between them.
std::string english(const std::vector<Message>& messages, std::string_view separator);

/// Returns a number with this many decimals, as an argument.
std::string fixed(double value, int decimals);
/// The same with its sign, also a plus.
std::string signedFixed(double value, int decimals);

/// Returns the source with `part(n)` in place of every %n, n from 1 to 9.
template <class Part>
std::string filled(std::string_view source, Part&& part)
{
    std::string text;
    for (std::size_t i = 0; i < source.size(); ++i) {
        const bool isPlace = source[i] == '%' && i + 1 < source.size() && source[i + 1] >= '1'
                          && source[i + 1] <= '9';
        if (isPlace)
            text += part(static_cast<std::size_t>(source[++i] - '0'));
        else
            text += source[i];
    }
    return text;
}

/// Returns the message with '?' in place of control characters, in its arguments too.
Message withoutControls(Message message);

}  // namespace terratact
