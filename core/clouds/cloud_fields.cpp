#include "core/clouds/cloud_fields.h"

#include <limits>

#include "core/base/text.h"
#include "core/store/csv_field.h"

namespace terratact {
namespace {

constexpr std::string_view kBlankSigns = " \t\r";

bool isMark(char c)
{
    return c == ',' || c == ';';
}

}  // namespace

void splitCloudFields(std::string_view line, std::vector<std::string_view>& fields)
{
    fields.clear();
    std::size_t at = line.find_first_not_of(kBlankSigns);
    while (at < line.size() && fields.size() < kMaxCloudFields) {
        const std::size_t end = std::min(line.find_first_of(" \t\r,;", at), line.size());
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
    return numberFrom(field);
}

}  // namespace terratact
