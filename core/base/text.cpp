#include "core/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace terratact {

std::string numberText(double value)
{
    std::array<char, 32> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end};  // 24 characters suffice for every double
}

std::string randomErrorText(double sd, int decimals)
{
    const double least = std::pow(10.0, -decimals);
    return sd < 0.5 * least ? fmt::format("< {:.{}f}", least, decimals)
                            : fmt::format("{:.{}f}", sd, decimals);
}

std::string rhatText(double rhat)
{
    constexpr double kMax = 100.0;
    return rhat > kMax ? fmt::format("> {:.0f}", kMax) : fmt::format("{:.3f}", rhat);
}

std::optional<double> numberFrom(std::string_view text)
{
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return value;
}

namespace {

/// Removes the first UTF-8 character from a text and returns it; empty if the bytes spell none.
std::optional<char32_t> nextCharacter(std::string_view& text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80 ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
    if (length == 0 || text.size() < length) return std::nullopt;
    char32_t value = length == 1 ? first : first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return std::nullopt;
        value = value << 6U | (byte(i) & 0x3FU);
    }
    constexpr std::array<char32_t, 5> kMin{0, 0, 0x80, 0x800, 0x10000};
    if (value < kMin.at(length) || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF))
        return std::nullopt;
    text.remove_prefix(length);
    return value;
}

/// Returns true for control characters of ASCII and Latin-1, line ends, and marks that change the
/// reading direction.
bool hidesOrMoves(char32_t c)
{
    const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
    return c < 0x20 || within(0x7F, 0x9F) || within(0x200B, 0x200F) || within(0x2028, 0x202E)
        || within(0x2060, 0x2069) || c == 0x061C || c == 0xFEFF;
}

}  // namespace

bool isUtf8(std::string_view text)
{
    while (!text.empty())
        if (!nextCharacter(text)) return false;
    return true;
}

bool isReadableName(std::string_view text)
{
    constexpr int kMax = 100;
    int characters = 0;
    while (!text.empty()) {
        const auto next = nextCharacter(text);
        if (!next || hidesOrMoves(*next) || ++characters > kMax) return false;
    }
    return characters > 0;
}

std::string shown(std::string_view text)
{
    constexpr int kMaxLength = 40;
    std::string line = "'";
    for (int i = 0; i < kMaxLength && !text.empty(); ++i) {
        const std::string_view before = text;
        const auto next = nextCharacter(text);
        if (!next) text.remove_prefix(1);
        if (next == U'\t')
            line += "<tab>";
        else if (next && !hidesOrMoves(*next))
            line += before.substr(0, before.size() - text.size());
        else
            line += '?';
    }
    line += text.empty() ? "'" : "…'";
    return line;
}

namespace {

std::string printableBut(std::string_view text, char32_t kept)
{
    std::string line;
    line.reserve(text.size());
    while (!text.empty()) {
        const std::string_view before = text;
        const auto next = nextCharacter(text);
        if (!next) text.remove_prefix(1);
        if (next && (!hidesOrMoves(*next) || (*next == kept && kept != 0)))
            line += before.substr(0, before.size() - text.size());
        else
            line += '?';
    }
    return line;
}

}  // namespace

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return lower;
}

std::string printable(std::string_view text)
{
    return printableBut(text, 0);
}

std::string printableLines(std::string_view text)
{
    return printableBut(text, U'\n');
}

std::string_view beginningOf(std::string_view text, std::size_t most)
{
    if (text.size() <= most) return text;
    const auto continues = [text](std::size_t at) {
        return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80;
    };
    std::size_t end = most;
    while (end > 0 && most - end < 4 && continues(end)) --end;
    return text.substr(0, continues(end) ? most : end);
}

}  // namespace terratact
