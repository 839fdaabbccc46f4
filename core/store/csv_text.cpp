#include "core/store/csv_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/text.h"

namespace terratact {
namespace {

constexpr std::array<std::string_view, 11> kFormulaBegins{
    "=",           "+", "-", "@", "\t", "\r", "\n", "\xEF\xBC\x9D", "\xEF\xBC\x8B", "\xEF\xBC\x8D",
    "\xEF\xBC\xA0"};

/// Where cells end in a program that does not separate at commas. It reads our quotes as text. Cells
/// between commas are protected by their quotes.
constexpr std::string_view kCellEnds = ";\t\r\n";

/// Returns true if the text behind any apostrophes, quotes and spaces begins a formula. A text that
/// begins with apostrophes must come back with as many.
bool beginsFormula(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of("' \""), text.size()));
    return std::any_of(kFormulaBegins.begin(), kFormulaBegins.end(),
                       [text](std::string_view sign) { return text.starts_with(sign); });
}

/// Returns true if a cell that begins at this byte would be a formula. The first of several
/// separators in a row begins none.
bool isFormulaAt(std::string_view text, std::size_t at)
{
    const auto endsCell = [text](std::size_t i) {
        return kCellEnds.find(text[i]) != std::string_view::npos;
    };
    return (at == 0 || (endsCell(at - 1) && !endsCell(at))) && beginsFormula(text.substr(at));
}

/// Puts an apostrophe before each cell that would be a formula.
std::string defused(std::string_view text)
{
    std::string cells;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (isFormulaAt(text, i)) cells += '\'';
        cells += text[i];
    }
    return cells;
}

bool isPlainNumber(std::string_view text)
{
    if (text.starts_with('+')) text.remove_prefix(1);
    return !text.empty() && text.front() != '+' && numberFrom(text).has_value();
}

bool needsQuotes(std::string_view text)
{
    if (text.empty()) return false;
    return text.find_first_of(",;\t\"\r\n") != std::string_view::npos || text.front() == ' '
        || text.back() == ' ';
}

}  // namespace

std::string csvField(std::string_view text)
{
    std::string field = isPlainNumber(text) ? std::string(text) : defused(text);
    if (!needsQuotes(field)) return field;
    std::string quoted = "\"";
    for (const char c : field) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + "\"";
}

CsvValue::CsvValue(double value) : text_(fmt::format("{}", value)) {}

CsvValue::CsvValue(std::optional<double> value) : CsvValue(value ? CsvValue(*value) : CsvValue()) {}

CsvValue signedTenth(double value)
{
    return fmt::format("{:+.1f}", value);
}

CsvValue rounded(double value, int digits)
{
    return fmt::format("{:.{}g}", value, digits);
}

std::string csvLine(std::span<const CsvValue> fields)
{
    std::string line;
    for (const CsvValue& field : fields) {
        if (&field != fields.data()) line += ',';
        line += csvField(field.text());
    }
    line += '\n';
    return line;
}

std::string csvLine(std::initializer_list<CsvValue> fields)
{
    return csvLine(std::span(fields.begin(), fields.size()));
}

std::string csvLine(std::span<const std::string> fields)
{
    return csvLine(std::vector<CsvValue>(fields.begin(), fields.end()));
}

std::string csvText(std::string_view field)
{
    std::string text;
    for (std::size_t i = 0; i < field.size(); ++i)
        if (field[i] != '\'' || !isFormulaAt(field, i)) text += field[i];
    return text;
}

}  // namespace terratact
