#pragma once

#include <string>
#include <string_view>

namespace terratact {

// Text in CSV files.  A spreadsheet takes a field that begins with = + - @, a tab or a line end (or the wide forms of
// these signs) for a formula, and would compute it.  An apostrophe in front makes it a text.

/// A text as a field of a CSV file: with an apostrophe in front where it would be a formula and is no number, in
/// quotes as RFC 4180 has it where it holds a separator, a quote or a line end, or begins or ends with a blank.
std::string csvField(std::string_view text);

/// The text that csvField() made a field of, once its quotes are off: without that apostrophe.
std::string_view csvText(std::string_view field);

}  // namespace terratact
