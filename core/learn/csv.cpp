#include "core/learn/csv.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/file_read.h"
#include "core/text.h"

namespace terratact {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} * 1024 * 1024;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string_view withoutBlanks(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t";
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

}  // namespace

CsvReader::CsvReader(std::string name, std::string text)
    : name_(std::move(name)), text_(std::make_unique<const std::string>(std::move(text))),
      rest_(*text_)
{
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

Result<CsvReader> CsvReader::open(const std::string& path)
{
    Result<std::string> text = readFile(path, kMostBytes);
    if (!text) return text.error();
    return over(path, *std::move(text));
}

Result<CsvReader> CsvReader::over(std::string name, std::string text)
{
    CsvReader reader(std::move(name), std::move(text));
    if (reader.rest_.empty()) return fileError(reader.name_, "is empty");
    if (reader.rest_.back() == '\n') return reader;
    const auto ends = std::count(reader.rest_.begin(), reader.rest_.end(), '\n');
    return fileError(reader.name_, "line " + std::to_string(ends + 1)
                                       + ": is torn: the file does not end with a line end");
}

Result<bool> CsvReader::next()
{
    fields_.clear();
    if (rest_.empty()) return false;
    ++line_;
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (withoutBlanks(line).empty()) return error("is blank");
    if (line.find('"') != std::string_view::npos)
        return error("has a quoted field, which is not supported: leave the quotes out");
    for (;;) {
        const std::size_t comma = line.find(',');
        if (fields_.size() == kMostFields)
            return error("has more than " + std::to_string(kMostFields) + " fields");
        if (std::min(comma, line.size()) > kLongestField)
            return error("has a field of more than " + std::to_string(kLongestField) + " bytes");
        fields_.push_back(line.substr(0, comma));
        if (comma == std::string_view::npos) return true;
        line.remove_prefix(comma + 1);
    }
}

Result<double> CsvReader::number(std::size_t field, std::string_view what) const
{
    const std::string_view text = fields_.at(field);
    const std::optional<double> value = numberFrom(withoutBlanks(text));
    if (!value) return error(std::string(what) + " is not a number: " + shown(text));
    if (!std::isfinite(*value)) return error(std::string(what) + " is not finite: " + shown(text));
    return *value;
}

Error CsvReader::error(std::string_view cause) const
{
    return fileError(name_, "line " + std::to_string(line_) + ": " + std::string(cause));
}

}  // namespace terratact
