#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace terratact {

/// Splits a line of a text at blanks, tabs, commas and semicolons. A comma or semicolon with blanks around it
/// is one separator, two of them have an empty field between them. Commas belong to the numbers where
/// semicolons, tabs or blanks alone separate them. At most kMaxCloudFields fields.
void splitCloudFields(std::string_view line, std::vector<std::string_view>& fields);
inline constexpr std::size_t kMaxCloudFields = 4096;

/// Returns the number that a field spells, also with a decimal comma. NaN for an empty field, "nan"
/// and other words for a missing value. Empty if it spells none.
std::optional<double> cloudCoordinate(std::string_view field);

}  // namespace terratact
