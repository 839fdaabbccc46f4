#include "core/wire/dbc/dbc_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/base/text.h"

namespace terratact {
namespace {

/// Returns the number of bytes of the UTF-8 character at `at`; 0: it is none.
std::size_t utf8Length(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(at);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || text.size() - at < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(at + i) & 0xC0U) != 0x80) return 0;
    const unsigned char second = byte(at + 1);
    const bool isTooLong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool isNoCharacter =
        (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
    return isTooLong || isNoCharacter ? 0 : length;
}
}  // namespace

std::string fromWindows1252(std::string_view text)
{
    // 0x80 … 0x9F. The five without a letter are control characters, which readable() removes.
    constexpr std::array<std::uint16_t, 32> kUpper{
        0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
        0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
        0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};
    std::string utf8;
    utf8.reserve(text.size() + text.size() / 8);
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const unsigned letter = byte >= 0x80 && byte < 0xA0 ? kUpper.at(byte - 0x80U) : byte;
        if (letter < 0x80) {
            utf8 += static_cast<char>(letter);
            continue;
        }
        if (letter < 0x800) {
            utf8 += static_cast<char>(0xC0U | letter >> 6U);
        } else {
            utf8 += static_cast<char>(0xE0U | letter >> 12U);
            utf8 += static_cast<char>(0x80U | (letter >> 6U & 0x3FU));
        }
        utf8 += static_cast<char>(0x80U | (letter & 0x3FU));
    }
    return utf8;
}

std::string readable(std::string_view utf8, std::size_t most, bool keepsLines)
{
    std::string text;
    for (std::size_t at = 0; at < utf8.size();) {
        const std::size_t length = std::max<std::size_t>(1, utf8Length(utf8, at));
        const std::string_view character = utf8.substr(at, length);
        at += length;
        if (text.size() + length > most) return text + "…";
        const bool isUpperControl = length == 2 && character[0] == '\xC2'
                                 && static_cast<unsigned char>(character[1]) < 0xA0;
        if (character == "\r" || (character == "\\" && utf8.substr(at).starts_with('"'))) continue;
        if (character == "\n" && keepsLines)
            text += '\n';
        else if (isControl(character[0]) || isUpperControl)
            text += ' ';
        else
            text += character;
    }
    return text;
}

}  // namespace terratact
