#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace terratact {

/// Splits a line of a text at blanks, tabs, commas and semicolons. A comma or semicolon with blanks around it is one
/// separator; between two of them lies an empty field. If only semicolons, tabs or blanks separate the numbers, commas
/// belong to the numbers. At most kMaxCloudFields fields.
void splitCloudFields(std::string_view line, std::vector<std::string_view>& fields);
inline constexpr std::size_t kMaxCloudFields = 4096;

/// Returns the number in a field, also with a decimal comma. NaN for an empty field, "nan" and other
/// words for a missing value. Empty if the field is not a number.
std::optional<double> cloudCoordinate(std::string_view field);

}  // namespace terratact
