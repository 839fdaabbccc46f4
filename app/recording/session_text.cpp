#include "app/recording/session_text.h"

#include <fmt/format.h>

#include <array>
#include <ctime>
#include <filesystem>
#include <limits>

namespace terratact {

namespace {

constexpr std::int64_t kNanosecondsInSecond = 1'000'000'000;  // [ns]

std::string calendar(std::int64_t wallTime, const std::tm& when, const char* zone)
{
    std::array<char, 40> date{};
    std::strftime(date.data(), date.size(), "%Y-%m-%d %H:%M:%S", &when);
    return fmt::format("{}.{:03} {}", date.data(), wallTime % kNanosecondsInSecond / 1'000'000,
                       zone);
}

}  // namespace

std::int64_t wallTimeOf(const SessionStart& start, SessionTime time)
{
    std::int64_t sum = 0;
    if (__builtin_add_overflow(start.wallTime, time, &sum))
        return time > 0 ? std::numeric_limits<std::int64_t>::max() : 0;
    return sum < 0 ? 0 : sum;
}

std::string utcText(std::int64_t wallTime)
{
    const std::time_t seconds = wallTime / kNanosecondsInSecond;
    std::tm when{};
    gmtime_r(&seconds, &when);
    return calendar(wallTime, when, "UTC");
}

std::string localText(std::int64_t wallTime)
{
    const std::time_t seconds = wallTime / kNanosecondsInSecond;
    std::tm when{};
    localtime_r(&seconds, &when);
    return calendar(wallTime, when, when.tm_zone);
}

std::string nanosecondText(std::int64_t wallTime)
{
    return fmt::format("{}.{:09}", wallTime / kNanosecondsInSecond,
                       wallTime % kNanosecondsInSecond);
}

std::string momentText(SessionTime time)
{
    return fmt::format("{:.3f} s", secondsOf(time));
}

Message damageMessage(const SessionStart& start, const SessionDamage& damage)
{
    return {TR_NOOP("Report", "%1 (%2) to %3: %4"), utcText(wallTimeOf(start, damage.first)),
            momentText(damage.first), momentText(damage.last), damage.why};
}

std::string damageText(const SessionStart& start, const SessionDamage& damage)
{
    return damageMessage(start, damage).english();
}

std::string driveName(const std::string& path)
{
    std::string stem = std::filesystem::path(path).stem().string();
    for (char& c : stem)
        if (c == ',' || c == '"' || static_cast<unsigned char>(c) < 0x20) c = '_';
    return stem;
}

}  // namespace terratact
