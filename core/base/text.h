#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace terratact {

/// Returns the shortest decimal text that reads back as exactly this value, the same in every
/// locale.
std::string numberText(double value);

/// Returns the sd of a random estimate, which is never 0: "0.01", or "< 0.01" if it would round to
/// 0.
std::string randomErrorText(double sd, int decimals);

/// Returns R-hat for display: "1.061", or "> 100". Beyond 100 only its excess matters; stuck chains
/// would give infinity.
std::string rhatText(double rhat);

/// Returns the number that the whole text spells, the same in every locale. Empty if it spells
/// none, or one beyond a double. "nan" and "inf" are numbers here: the caller must check.
std::optional<double> numberFrom(std::string_view text);

/// Returns the integer that the whole text spells; empty if it spells none, or one beyond
/// `Integer`.
template <class Integer>
std::optional<Integer> integerFrom(std::string_view text, int base = 10)
{
    Integer value{};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value, base);
    return error == std::errc{} && rest == end ? std::optional(value) : std::nullopt;
}

/// Returns the integer only if the text is what std::to_string() writes. Our own files have no
/// other spelling.
template <class Integer>
std::optional<Integer> writtenIntegerFrom(std::string_view text)
{
    const auto value = integerFrom<Integer>(text);
    return value && std::to_string(*value) == text ? value : std::nullopt;
}

/// Returns true for a control character of ASCII (line end, escape, DEL …). No part of another
/// UTF-8 character is one.
constexpr bool isControl(char c)
{
    return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
}

/// Returns true if every byte is part of a UTF-8 character.
bool isUtf8(std::string_view text);

/// Returns true if a UTF-8 text may be a name that people read. It has 1 to 100 characters, and
/// every byte is part of a character. None is a control character, a line end, or a mark that
/// changes the reading direction.
bool isReadableName(std::string_view text);

/// Returns a part of a file for a message, in quotes and cut after 40 characters. A tab becomes
/// "<tab>", another unprintable character '?'.
std::string shown(std::string_view text);

/// Returns a text of a file for a terminal. The line moves no cursor, changes no colour and hides
/// nothing. Characters that isReadableName() refuses become '?', and so do bytes that are not
/// UTF-8.
std::string printable(std::string_view text);

/// Returns the same for a text of several lines; line ends are kept.
std::string printableLines(std::string_view text);

/// Returns the text with the letters A to Z in lower case.
std::string lowerCase(std::string_view text);

/// Returns the first bytes of a text, at most `most`, without a split UTF-8 character.
std::string_view beginningOf(std::string_view text, std::size_t most);

}  // namespace terratact
