#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace terratact {

/// Blanks around a field of a CSV file.
inline constexpr std::string_view kCsvBlanks = " \t";

/// Cause of an error at a record that repeats the header of its file.
inline constexpr SourceText kSecondTable = TR_NOOP(
    "core", "repeats the header: a second table begins here: save each table as a file of its own");

/// Returns the text without the blanks at its begin and end.
std::string_view withoutBlanks(std::string_view text, std::string_view blanks = kCsvBlanks);
/// Returns the text without blanks of any kind at its begin and end: also no-break, figure and
/// zero-width spaces, and byte order marks.
std::string_view withoutPadding(std::string_view text);
/// Returns a unit without blanks and without the brackets around it.
std::string_view withoutBrackets(std::string_view text);

/// Returns the number that the text spells, without its padding. A decimal comma is allowed only if
/// `commaIsDecimal`.
std::optional<double> csvNumber(std::string_view text, bool commaIsDecimal);
/// Returns true for an empty field and for words such as NaN, NA and null.
bool isMissingWord(std::string_view text);

/// Number of each separator in a line, outside of quotes. A tab beside another separator is a
/// blank.
struct SeparatorCounts {
    std::size_t commas = 0, semicolons = 0, tabs = 0;
};

SeparatorCounts countSeparators(std::string_view line);

/// Returns true if all fields of a line without quotes spell numbers.
bool allNumbers(std::string_view line, char separator);

}  // namespace terratact
