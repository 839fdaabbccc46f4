#include "core/bags/csv_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/bags/time_unit.h"
#include "core/base/text.h"
#include "core/store/csv_reader.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr double kNanosecond = 1e-9;
constexpr std::array<std::string_view, 8> kTimeNames{"__time", "%time", "time",    "timestamp",
                                                     "stamp",  "t",     "seconds", "time stamp"};
constexpr std::array<std::pair<std::string_view, double>, 9> kTimeEndings{{{"_ns", 1e-9},
                                                                           {"_us", 1e-6},
                                                                           {"_ms", 1e-3},
                                                                           {"_s", 1.0},
                                                                           {"[ns]", 1e-9},
                                                                           {"[us]", 1e-6},
                                                                           {"[ms]", 1e-3},
                                                                           {"[s]", 1.0},
                                                                           {"", 0.0}}};

/// A column's name in lower case without the ending that names its unit.
struct NamedTime {
    std::string name;
    double unit = 0.0;
};

NamedTime namedTime(std::string_view column)
{
    std::string name(column);
    std::ranges::transform(name, name.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    for (const auto& [ending, unit] : kTimeEndings)
        if (name.ends_with(ending)) {
            name.resize(name.size() - ending.size());
            while (name.ends_with(' ')) name.pop_back();
            return {std::move(name), unit};
        }
    return {std::move(name), 0.0};
}

constexpr std::size_t kUnitRows = 1'000;  // that show the unit of times

/// Times at the begin of a file.
struct FirstTimes {
    double first = 0.0;
    double step = 0.0;  ///< middle one that rises; 0: none does
};

/// Reads the first times of a file below its header, and leaves out what is no number.
FirstTimes firstTimes(CsvReader& csv, std::size_t column)
{
    std::vector<double> times, steps;
    while (times.size() < kUnitRows) {
        const auto more = csv.next();
        if (!more || !*more) break;
        if (const auto time = csv.number(column, "")) times.push_back(*time);
    }
    for (std::size_t i = 1; i < times.size(); ++i)
        if (times[i] > times[i - 1]) steps.push_back(times[i] - times[i - 1]);
    if (steps.empty()) return {times.empty() ? 0.0 : times.front(), 0.0};
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
    std::ranges::nth_element(steps, middle);
    return {times.front(), *middle};
}

/// Returns a time [ns] without rounding, if the text is a decimal number of at most 18 digits.
std::optional<std::int64_t> exactTime(std::string_view text, double unit)
{
    int decimals = static_cast<int>(std::lround(std::log10(unit / kNanosecond)));
    const std::size_t point = std::min(text.find('.'), text.size());
    std::string digits(text.substr(0, point));
    for (const char c : text.substr(std::min(point + 1, text.size())))
        if (decimals-- > 0) digits += c;
    for (; decimals > 0; --decimals) digits += '0';
    return integerFrom<std::int64_t>(digits);
}

class CsvRecording final : public Recording {
public:
    CsvRecording(const std::string& path, CsvReader reader, std::vector<std::string> columns,
                 std::size_t timeColumn, double unit, std::string unitRemark)
        : Recording(path), reader_(std::move(reader)), columns_(std::move(columns)),
          timeColumn_(timeColumn), unit_(unit)
    {
        if (!unitRemark.empty()) note(std::move(unitRemark));
        topics_.push_back({.name = kCsvTopic, .type = "table", .encoding = kCsvEncoding});
    }

    std::string_view format() const override { return "CSV"; }

    Result<bool> next(RecordedMessage& message) override
    {
        if (!isSelected(topics_.front())) return false;
        auto more = reader_.next();
        if (!more && reader_.lacksLineEnd()) {
            remark("ends within its last line, which is left out");
            return false;
        }
        if (!more || !*more) return more;
        if (std::exchange(isFirst_, false) && isOfUnits()) return next(message);
        const auto time = readTime();
        if (!time) return time.error();
        message = {.topic = 0,
                   .time = *time,
                   .offset = static_cast<std::uint64_t>(reader_.line()),
                   .data = {}};
        return true;
    }

    Result<FieldValue> decode(const RecordedMessage&) override
    {
        FieldValue row;
        row.kind = FieldValue::Kind::Members;
        row.parts.reserve(columns_.size());
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            row.parts.push_back(valueOf(i));
            row.parts.back().name = columns_[i];
        }
        return row;
    }

private:
    FieldValue valueOf(std::size_t column)
    {
        if (reader_.isMissing(column)) return {};
        if (const auto number = reader_.number(column, columns_[column]))
            return FieldValue::of(*number);
        if (reader_.isNumber(column)) return {};  // infinite
        return FieldValue::of(std::string(reader_.fields()[column]));
    }

    /// Returns true, with a remark, for a line below the header that has units instead of numbers.
    bool isOfUnits()
    {
        std::string units;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const std::string_view field = reader_.fields()[i];
            if (reader_.isMissing(i)) continue;
            if (field.find_first_of("0123456789:") != std::string_view::npos) return false;
            if (units.find(shown(field)) == std::string::npos && units.size() < 80)
                units += (units.empty() ? "" : ", ") + shown(field);
        }
        if (units.empty()) return false;
        note(fmt::format("line {} holds no number but {}, and is left out; where these are "
                         "units, the mapping must give them",
                         reader_.line(), units));
        return true;
    }

    Result<std::int64_t> readTime()
    {
        const auto number = reader_.number(timeColumn_, columns_[timeColumn_]);
        const std::string_view text = reader_.fields()[timeColumn_];
        if (!number && text.find(':') != std::string_view::npos)
            return reader_.error(
                fmt::format("{} is {}, a date or a clock, expected a number: "
                            "export times as seconds since 1970 or since the begin",
                            shown(columns_[timeColumn_]), shown(text)));
        if (!number) return number.error();
        if (const auto exact = exactTime(reader_.fields()[timeColumn_], unit_)) return *exact;
        const double time = *number * unit_ / kNanosecond;
        if (!(std::abs(time) < 9.2e18))
            return reader_.error(fmt::format(
                "column {} is {} times {} s, later than the year 2262: name its unit in the "
                "mapping, such as [csv] time_unit = \"ns\"",
                shown(columns_[timeColumn_]), numberText(*number), numberText(unit_)));
        return static_cast<std::int64_t>(std::llround(time));
    }

    CsvReader reader_;
    std::vector<std::string> columns_;
    std::size_t timeColumn_;
    bool isFirst_ = true;  ///< the first line below the header is next
    double unit_;          ///< [s]
};

std::string listOf(const std::vector<std::string>& columns)
{
    constexpr std::size_t kMaxListed = 12;
    std::string list;
    for (std::size_t i = 0; i < std::min(columns.size(), kMaxListed); ++i)
        list += fmt::format("{}{}", i > 0 ? ", " : "", shown(columns[i]));
    return columns.size() > kMaxListed ? list + ", …" : list;
}

/// Returns the first lines of a text, at most `count`.
std::string firstLines(const std::string& text, std::size_t count)
{
    std::size_t end = 0;
    for (; count > 0 && end < text.size(); --count)
        end = std::min(text.find('\n', end), text.size() - 1) + 1;
    return text.substr(0, end);
}

/// Returns the unit of times [s] from the first rows of a text. remark: what is taken for granted, if anything is.
Result<double> unitIn(const std::string& path, std::string text,
                      const std::vector<std::string>& columns, std::size_t timeColumn,
                      std::string& remark)
{
    auto csv = CsvReader::over(path, std::move(text));
    if (!csv) return csv.error();
    if (const auto header = csv->next(); !header) return header.error();
    csv->useAsHeader(std::vector<std::string>(columns.size()));
    const FirstTimes times = firstTimes(*csv, timeColumn);
    const TimeUnit unit = timeUnitOf(times.first, times.step);
    if (times.step > 1.0 && timeUnitOf(times.first, 0.0).seconds != unit.seconds)
        remark = fmt::format("column {} rises by {} from row to row and is taken for {}; if it is "
                             "not, name its unit in the mapping: [csv] time_unit",
                             shown(columns[timeColumn]), numberText(times.step), unit.name);
    return unit.seconds;
}

}  // namespace

Result<std::unique_ptr<Recording>> openCsvRecording(const std::string& path, const CsvTime& time)
{
    auto text = CsvReader::textOf(path);
    if (!text) return text.error();
    std::string head = firstLines(*text, 2 * kUnitRows);  // blank lines count, too
    auto csv = CsvReader::over(path, *std::move(text));
    if (!csv) return csv.error();
    const auto more = csv->next();
    if (!more) return more.error();
    if (!*more) return fileError(path, "holds no row, expected a line with the names of columns");
    std::vector<std::string> columns(csv->fields().begin(), csv->fields().end());
    while (!columns.empty() && columns.back().empty()) columns.pop_back();
    std::optional<std::size_t> timeColumn;
    double unit = time.unit;
    for (const std::string_view wanted : kTimeNames)
        for (std::size_t i = 0; i < columns.size() && !timeColumn; ++i) {
            const NamedTime named = namedTime(columns[i]);
            if (!(time.column.empty() ? named.name == wanted : columns[i] == time.column)) continue;
            timeColumn = i;
            if (unit == 0.0) unit = named.unit;
        }
    if (!timeColumn)
        return csv->error(fmt::format(
            "has no column of times{}; its columns are {}; name one in the "
            "mapping: [csv] time_column",
            time.column.empty() ? "" : fmt::format(" {}", shown(time.column)), listOf(columns)));
    csv->useAsHeader(std::vector<std::string>(columns.size()));
    std::string unitRemark;
    if (unit == 0.0) {
        const auto found = unitIn(path, std::move(head), columns, *timeColumn, unitRemark);
        if (!found) return found.error();
        unit = *found;
    }
    return std::unique_ptr<Recording>(std::make_unique<CsvRecording>(
        path, std::move(*csv), std::move(columns), *timeColumn, unit, std::move(unitRemark)));
}

}  // namespace terratact
