// Tests times and names of sessions as text.
#include "app/recording/session_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace terratact {
namespace {

TEST(SessionText, timesOfAnyFileAreDates)
{
    EXPECT_EQ(utcText(1'793'000'000'123'456'789), "2026-10-26 07:33:20.123 UTC");
    EXPECT_EQ(nanosecondText(1'793'000'000'000'000'123), "1793000000.000000123");
    constexpr auto kMax = std::numeric_limits<std::int64_t>::max();
    EXPECT_EQ(wallTimeOf({.wallTime = kMax}, 1), kMax);
    EXPECT_EQ(wallTimeOf({.wallTime = 5}, -6), 0);
    EXPECT_EQ(wallTimeOf({.wallTime = 5}, 6), 11);
    EXPECT_EQ(driveName("/a/b, c\".tts"), "b_ c_");
}

}  // namespace
}  // namespace terratact
