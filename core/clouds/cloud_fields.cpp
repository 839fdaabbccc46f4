#include "core/clouds/cloud_fields.h"

#include <algorithm>
#include <limits>
#include <string>

#include "core/base/text.h"
#include "core/store/csv_field.h"

namespace terratact {
namespace {

constexpr std::string_view kBlankSigns = " \t\r";

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Returns true if commas separate the fields. Commas between digits are decimal marks where
/// something else separates: semicolons, tabs, or blanks that stand without a comma.
bool commaSeparates(std::string_view line)
{
    if (line.find(',') == std::string_view::npos) return false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] != ',') continue;
        if (i == 0 || i + 1 == line.size() || !isDigit(line[i - 1]) || !isDigit(line[i + 1]))
            return true;
    }
    if (line.find_first_of(";\t") != std::string_view::npos) return false;
    const std::size_t begin = line.find_first_not_of(kBlankSigns);
    line = line.substr(begin, line.find_last_not_of(kBlankSigns) - begin + 1);
    for (std::size_t at = line.find(' '); at != std::string_view::npos; at = line.find(' ', at)) {
        const std::size_t end = std::min(line.find_first_not_of(kBlankSigns, at), line.size());
        if (line[at - 1] != ',' && line[end] != ',') return false;
        at = end;
    }
    return true;
}

}  // namespace

void splitCloudFields(std::string_view line, std::vector<std::string_view>& fields)
{
    fields.clear();
    const bool byComma = commaSeparates(line);
    const auto isMark = [byComma](char c) { return c == ';' || (byComma && c == ','); };
    const char* const ends = byComma ? " \t\r,;" : " \t\r;";
    std::size_t at = line.find_first_not_of(kBlankSigns);
    while (at < line.size() && fields.size() < kMaxCloudFields) {
        const std::size_t end = std::min(line.find_first_of(ends, at), line.size());
        fields.push_back(line.substr(at, end - at));
        at = std::min(line.find_first_not_of(kBlankSigns, end), line.size());
        if (at < line.size() && isMark(line[at]))
            at = std::min(line.find_first_not_of(kBlankSigns, at + 1), line.size());
    }
}

std::optional<double> cloudCoordinate(std::string_view field)
{
    if (isMissingWord(field)) return std::numeric_limits<double>::quiet_NaN();
    if (field.starts_with('+')) field.remove_prefix(1);
    const auto number = numberFrom(field);
    const std::size_t comma = field.find(',');
    if (number || comma == std::string_view::npos || field.find('.') != std::string_view::npos)
        return number;
    std::string text(field);
    text[comma] = '.';
    return numberFrom(text);
}

}  // namespace terratact
