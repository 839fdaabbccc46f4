#include "core/store/csv_field.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"

namespace terratact {

std::string_view withoutBlanks(std::string_view text, std::string_view blanks)
{
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string_view withoutPadding(std::string_view text)
{
    // U+00A0, U+2007, U+200B, U+202F, U+FEFF
    constexpr std::array<std::string_view, 7> kPads{
        " ", "\t", "\xC2\xA0", "\xE2\x80\x87", "\xE2\x80\x8B", "\xE2\x80\xAF", "\xEF\xBB\xBF"};
    const auto first = [&] {
        return std::ranges::find_if(kPads, [&](auto pad) { return text.starts_with(pad); });
    };
    const auto last = [&] {
        return std::ranges::find_if(kPads, [&](auto pad) { return text.ends_with(pad); });
    };
    for (auto pad = first(); pad != kPads.end(); pad = first()) text.remove_prefix(pad->size());
    for (auto pad = last(); pad != kPads.end(); pad = last()) text.remove_suffix(pad->size());
    return text;
}

SeparatorCounts countSeparators(std::string_view line)
{
    SeparatorCounts counts;
    bool quoted = false;
    const auto isSeparator = [&](std::size_t i) {
        return i < line.size() && (line[i] == ',' || line[i] == ';');
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        if (quoted) continue;
        counts.commas += line[i] == ',' ? 1 : 0;
        counts.semicolons += line[i] == ';' ? 1 : 0;
        const bool isBlank = isSeparator(i + 1) || (i > 0 && isSeparator(i - 1));
        counts.tabs += line[i] == '\t' && !isBlank ? 1 : 0;
    }
    return counts;
}

std::optional<double> csvNumber(std::string_view text, bool commaIsDecimal)
{
    constexpr std::string_view kMinus = "\xE2\x88\x92";  // U+2212
    if (const std::optional<double> value = numberFrom(text)) return value;
    std::string plain(withoutPadding(text));
    if (plain.starts_with(kMinus)) plain.replace(0, kMinus.size(), "-");
    if (plain.starts_with('+') && plain.size() > 1 && plain[1] != '-') plain.erase(0, 1);
    const bool oneComma = std::count(plain.begin(), plain.end(), ',') == 1;
    if (commaIsDecimal && oneComma && plain.find('.') == std::string::npos)
        plain[plain.find(',')] = '.';
    return numberFrom(plain);
}

bool isMissingWord(std::string_view text)
{
    constexpr std::array<std::string_view, 16> kWords{
        "",     "nan",    "-nan",    "+nan",    "na",       "n/a",  "#n/a", "#na",
        "<na>", "1.#ind", "-1.#ind", "1.#qnan", "-1.#qnan", "null", "none", "nil"};
    return text.size() <= 8 && std::ranges::find(kWords, lowerCase(text)) != kWords.end();
}

bool allNumbers(std::string_view line, char separator)
{
    for (;;) {
        const std::size_t end = line.find(separator);
        if (!csvNumber(withoutBlanks(line.substr(0, end)), separator != ',')) return false;
        if (end == std::string_view::npos) return true;
        line.remove_prefix(end + 1);
    }
}

std::string_view withoutBrackets(std::string_view text)
{
    const bool bracketed = text.size() > 2
                        && ((text.front() == '[' && text.back() == ']')
                            || (text.front() == '(' && text.back() == ')'));
    return bracketed ? withoutBlanks(text.substr(1, text.size() - 2)) : text;
}

}  // namespace terratact
