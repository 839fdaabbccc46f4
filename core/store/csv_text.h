#pragma once

#include <concepts>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace terratact {

// CSV text fields. A spreadsheet computes a cell that begins with = + - @, a tab, a line end or
// their wide forms. A leading apostrophe makes it a text. A spreadsheet that separates at ; takes a quote inside a line
// for an ordinary character. So a quoted text may become several cells.

/// Returns a text as a CSV field. A number stays as it is. In another text, each part that would be
/// a formula gets a leading apostrophe. Parts begin with the text and behind semicolons, tabs and
/// line ends. Apostrophes, quotes and spaces before the sign of a formula do not count. A text with
/// a separator, a quote, a line end or an outer blank is quoted as in RFC 4180.
std::string csvField(std::string_view text);

/// One field of a CSV line: a text or a number.
class CsvValue {
public:
    CsvValue() = default;
    CsvValue(std::string text) : text_(std::move(text)) {}
    CsvValue(std::string_view text) : text_(text) {}
    CsvValue(const char* text) : text_(text) {}
    /// The shortest text that reads back as this value.
    CsvValue(double value);
    CsvValue(std::optional<double> value);  ///< empty without a value
    template <std::integral Integer>
    CsvValue(Integer value) : text_(std::to_string(value))  // true is 1, false is 0
    {
    }

    const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// Returns a value with its sign and one decimal, as files write the centre of a bin: "+0.1".
CsvValue signedTenth(double value);

/// Returns a value rounded to this number of significant digits.
CsvValue rounded(double value, int digits);

/// Returns one line of a CSV file: csvField() of each value, separated by commas, with its line
/// end.
std::string csvLine(std::span<const CsvValue> fields);
std::string csvLine(std::initializer_list<CsvValue> fields);
std::string csvLine(std::span<const std::string> fields);

/// Returns the text of an unquoted field that csvField() made: it removes the added apostrophes.
std::string csvText(std::string_view field);

}  // namespace terratact
