#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/text.h"

namespace terratact {

/// A sentence as the source has it: English, with %1 … %9 for what it is told of, and the context in which translators
/// find it.  Points to literals.
struct SourceText {
    const char* context;
    const char* english;
};

/// Marks a sentence for the translators; resources/translations/update.sh finds it.
#define TR_NOOP(context, english) (terratact::SourceText{context, english})

/// What an operator is told: a sentence and its arguments, put into words where it is shown.  The core speaks English
/// (english()); the console translates the source text (widgets/base/translated.h).  An argument is a message, too: a
/// number or a name is one without a context, which is not translated.
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

    /// A text that is nobody's to translate: a name, a number, what another program said.
    static Message verbatim(std::string text);

    /// "first: then"
    static Message joined(Message first, Message then);

    bool empty() const { return source.empty(); }

    /// The sentence with its arguments in their places.
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

/// A number with so many decimals, as an argument.
std::string fixed(double value, int decimals);

/// The source with `part(n)` for every %n, n from 1 to 9.
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

/// For fmt::format.
std::string format_as(const Message& message);

}  // namespace terratact
