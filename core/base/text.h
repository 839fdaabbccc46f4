#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace terratact {

/// The shortest decimal text that reads back as exactly this value, the same in every locale.
std::string numberText(double value);

/// The sd of something that was drawn at random, which is never 0: "0.01", or "< 0.01" where it would round to 0.
std::string randomErrorText(double sd, int decimals);

/// R-hat as people read it: "1.061", or "> 100", where no more matters than that it is far too large: of chains that are
/// stuck it would be infinite.
std::string rhatText(double rhat);

/// The number a text spells, in full, the same in every locale; empty where it spells none or one beyond
/// a double.  "nan" and "inf" are numbers here: whoever reads must check.
std::optional<double> numberFrom(std::string_view text);

/// The integer a text spells, in full; empty where it spells none, or one beyond `Integer`.
template <class Integer>
std::optional<Integer> integerFrom(std::string_view text, int base = 10)
{
    Integer value{};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value, base);
    return error == std::errc{} && rest == end ? std::optional(value) : std::nullopt;
}

/// Likewise, and only as std::to_string() spells it: a file that we wrote has no other.
template <class Integer>
std::optional<Integer> writtenIntegerFrom(std::string_view text)
{
    const auto value = integerFrom<Integer>(text);
    return value && std::to_string(*value) == text ? value : std::nullopt;
}

/// Of ASCII: line ends, escapes, DEL … and no part of any other character of UTF-8.
constexpr bool isControl(char c)
{
    return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
}

/// Whether a text in UTF-8 may be a name that people read: 1 to 100 characters, none of them a control character, the end
/// of a line, or a mark that turns the direction of reading; and whole: no byte that is no part of a character.
bool isReadableName(std::string_view text);

/// A piece of a file for a message: in quotes, cut after 40 characters, a tab as "<tab>", others unprintable as '?'.
std::string shown(std::string_view text);

/// A whole text of somebody's file for a terminal: one line that moves no cursor, changes no colour and hides nothing.
/// As '?': what isReadableName() refuses in a name, and bytes that are not UTF-8.
std::string printable(std::string_view text);

/// Likewise of a text of several lines, whose line ends stay.
std::string printableLines(std::string_view text);

/// The first bytes of a text, at most `most`, and no half character of UTF-8.
std::string_view beginningOf(std::string_view text, std::size_t most);

}  // namespace terratact
