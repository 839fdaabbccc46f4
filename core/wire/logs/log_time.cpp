#include "core/wire/logs/log_time.h"

#include <chrono>
#include <cmath>
#include <ctime>

#include "core/base/text.h"
#include "core/wire/logs/log_text.h"

namespace terratact {
namespace {

std::optional<int> smallNumber(std::string_view digits)
{
    if (!isDigits(digits) || digits.size() > 4) return std::nullopt;
    return integerFrom<int>(digits);
}

bool isWithin(int value, int least, int most)
{
    return value >= least && value <= most;
}

}  // namespace

std::optional<double> secondsOfLocal(const LogDate& date)
{
    const bool isPossible = isWithin(date.year, 1970, 2200) && isWithin(date.month, 1, 12)
                         && isWithin(date.day, 1, 31) && isWithin(date.hour, 0, 23)
                         && isWithin(date.minute, 0, 59) && date.second >= 0.0
                         && date.second < 61.0;
    const std::chrono::year_month_day calendar{
        std::chrono::year(date.year), std::chrono::month(static_cast<unsigned>(date.month)),
        std::chrono::day(static_cast<unsigned>(date.day))};
    if (!isPossible || !calendar.ok()) return std::nullopt;
    const double whole = std::floor(date.second);
    std::tm parts{};
    parts.tm_year = date.year - 1900;
    parts.tm_mon = date.month - 1;
    parts.tm_mday = date.day;
    parts.tm_hour = date.hour;
    parts.tm_min = date.minute;
    parts.tm_sec = static_cast<int>(whole);
    parts.tm_isdst = -1;
    const std::time_t seconds = std::mktime(&parts);
    if (seconds < 0) return std::nullopt;
    return static_cast<double>(seconds) + (date.second - whole);
}

bool consumeClock(std::string_view clock, LogDate& date)
{
    const std::size_t first = clock.find(':');
    const std::size_t second = first == std::string_view::npos ? first : clock.find(':', first + 1);
    if (second == std::string_view::npos) return false;
    const auto hour = smallNumber(clock.substr(0, first));
    const auto minute = smallNumber(clock.substr(first + 1, second - first - 1));
    const auto seconds = logSeconds(clock.substr(second + 1));
    if (!hour || !minute || !seconds) return false;
    date.hour = *hour;
    date.minute = *minute;
    date.second = *seconds;
    return true;
}

std::optional<double> secondsOfDate(std::string_view date, std::string_view clock)
{
    LogDate when;
    if (date.size() != 10 || date[4] != '-' || date[7] != '-' || !consumeClock(clock, when))
        return std::nullopt;
    const auto year = smallNumber(date.substr(0, 4)), month = smallNumber(date.substr(5, 2)),
               day = smallNumber(date.substr(8, 2));
    if (!year || !month || !day) return std::nullopt;
    when.year = *year;
    when.month = *month;
    when.day = *day;
    return secondsOfLocal(when);
}

}  // namespace terratact
