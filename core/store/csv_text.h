#pragma once

#include <span>
#include <string>
#include <string_view>

namespace terratact {

// CSV text fields. A spreadsheet computes a field that begins with = + - @, a tab, a line end or
// their wide forms. A leading apostrophe makes it a text.

/// Returns a text as a CSV field. A text that would be a formula and is no number gets a leading
/// apostrophe. A text with a separator, a quote, a line end or an outer blank is quoted as in RFC
/// 4180.
std::string csvField(std::string_view text);

/// Returns one line of a CSV file: csvField() of each text, separated by commas, with its line end.
std::string csvLine(std::span<const std::string> fields);

/// Returns the text of an unquoted field that csvField() made: it removes the added apostrophe.
std::string_view csvText(std::string_view field);

}  // namespace terratact
