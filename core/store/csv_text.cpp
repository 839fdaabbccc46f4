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

/// Returns true if the text behind any apostrophes begins a formula. A text that begins with
/// apostrophes must come back with as many.
bool beginsFormula(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
    return std::any_of(kFormulaBegins.begin(), kFormulaBegins.end(),
                       [text](std::string_view sign) { return text.starts_with(sign); });
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
    std::string field(beginsFormula(text) && !isPlainNumber(text) ? "'" : "");
    field += text;
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

std::string_view csvText(std::string_view field)
{
    if (field.starts_with('\'') && beginsFormula(field)) field.remove_prefix(1);
    return field;
}

}  // namespace terratact
