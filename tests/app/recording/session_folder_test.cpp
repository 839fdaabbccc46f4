// Tests the folder of sessions: its place, the repair of dead sessions, and retention.
#include "app/recording/session_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "tests/support/sessions/session_paths.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct SessionFolder : testing::Test {
    TemporaryDirectory directory;
    std::string folder = directory.file("state/sessions");
};

constexpr std::int64_t kSecond = 1'000'000'000;                           // [ns]
constexpr std::int64_t kOctober = std::int64_t{1'793'000'000} * kSecond;  // start of someSession()
constexpr std::int64_t kLater = kOctober + 100 * 86'400 * kSecond;

/// Makes a closed session that ended at these times, by its own clock and by the file system's.
void makeClosed(const std::string& path, std::int64_t recorded = kOctober,
                std::int64_t written = kOctober, std::int64_t frames = 2000)
{
    SessionStart start = someStart();
    start.wallTime = recorded;
    auto writer = SessionWriter::create(path, start);
    ASSERT_TRUE(writer) << writer.error().text;
    for (std::int64_t n = 0; n < frames; ++n) ASSERT_TRUE(writer->add(someFrame(n)));
    ASSERT_TRUE(writer->seal());
    const timespec time{.tv_sec = written / kSecond, .tv_nsec = 0};
    const timespec both[2]{time, time};
    ASSERT_EQ(::utimensat(AT_FDCWD, path.c_str(), both, 0), 0);
}

TEST_F(SessionFolder, deletesOnlyWhatTheUsersLimitsSay)
{
    std::filesystem::create_directories(folder);
    makeClosed(folder + "/1.tts");
    makeClosed(folder + "/2.tts", kOctober + kSecond, kOctober + kSecond);
    std::ofstream(folder + "/2019.tts") << "no session";
    const auto told = [&](const RetentionLimits& limits) {
        return applyRetention(sessionsIn(folder), limits, kLater).size();
    };
    EXPECT_EQ(told({.confirmed = true}), 0U);
    EXPECT_EQ(told({.days = 101.0, .confirmed = true}), 0U);
    const double one = static_cast<double>(std::filesystem::file_size(folder + "/1.tts"));
    EXPECT_EQ(told({.gigabytes = 1.5e-9 * one, .confirmed = true}), 1U);
    EXPECT_EQ(filesIn(folder).size(), 2U);
    EXPECT_TRUE(std::filesystem::exists(folder + "/2.tts")) << "the oldest goes";
    EXPECT_EQ(told({.days = 99.0, .confirmed = true}), 1U);
    EXPECT_FALSE(std::filesystem::exists(folder + "/2.tts"));
    EXPECT_TRUE(std::filesystem::exists(folder + "/2019.tts")) << "what is no session stays";
}

TEST_F(SessionFolder, deletesNothingThatWasNotConfirmed)
{
    std::filesystem::create_directories(folder);
    makeClosed(folder + "/1.tts");
    makeClosed(folder + "/2.tts");
    const auto told = applyRetention(sessionsIn(folder), {.days = 30.0}, kLater);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_NE(told[0].english().find("2 sessions ("), std::string::npos) << told[0].english();
    EXPECT_NE(told[0].english().find("None is deleted until"), std::string::npos)
        << told[0].english();
    EXPECT_EQ(filesIn(folder).size(), 2U);
}

TEST_F(SessionFolder, keepsSessionsOfUnknownAge)
{
    std::filesystem::create_directories(folder);
    const std::int64_t year1970 = 5 * kSecond, recent = kLater - 2 * kSecond;
    makeClosed(folder + "/flat-battery.tts", year1970, year1970);
    makeClosed(folder + "/flat-battery-copied.tts", year1970, kOctober);
    makeClosed(folder + "/future.tts", kLater + 3 * 86'400 * kSecond, kOctober);
    makeClosed(folder + "/touched.tts", kOctober, recent);
    makeClosed(folder + "/back-dated.tts", recent, kOctober);
    makeClosed(folder + "/old.tts", kOctober, kOctober);
    const auto all = [&](std::int64_t now) {
        return applyRetention(sessionsIn(folder),
                              {.days = 30.0, .gigabytes = 1e-9, .confirmed = true}, now);
    };
    EXPECT_EQ(all(year1970).size(), 0U) << "this computer's own clock cannot be true";
    EXPECT_EQ(applyRetention(sessionsIn(folder), {.days = 30.0, .confirmed = true}, kLater).size(),
              1U);
    EXPECT_FALSE(std::filesystem::exists(folder + "/old.tts"));
    EXPECT_EQ(all(kLater).size(), 2U) << "whose times can be true";
    EXPECT_EQ(filesIn(folder).size(), 3U);
}

TEST_F(SessionFolder, oldestIsWhatEndedFirstWhateverItsName)
{
    std::filesystem::create_directories(folder);
    makeClosed(folder + "/1.tts", kOctober + 9 * kSecond, kOctober);
    makeClosed(folder + "/2.tts");
    const double one = static_cast<double>(std::filesystem::file_size(folder + "/1.tts"));
    EXPECT_EQ(
        applyRetention(sessionsIn(folder), {.gigabytes = 1.5e-9 * one, .confirmed = true}, kLater)
            .size(),
        1U);
    EXPECT_TRUE(std::filesystem::exists(folder + "/1.tts"));
}

TEST_F(SessionFolder, stopsDeletingWhenCancelled)
{
    std::filesystem::create_directories(folder);
    for (int i = 0; i < 6; ++i) makeClosed(folder + "/" + std::to_string(i) + ".tts");
    const RetentionLimits none{.gigabytes = 1e-9, .confirmed = true};
    int asked = 0;
    const auto apply = [&](int most) {
        asked = 0;
        return applyRetention(sessionsIn(folder), none, kLater, [&] { return ++asked <= most; })
            .size();
    };
    EXPECT_EQ(apply(3), 0U) << "it had not seen all of them";
    EXPECT_EQ(asked, 4) << "nor looked at more";
    EXPECT_EQ(apply(8), 2U);
    EXPECT_EQ(filesIn(folder).size(), 4U);
}

TEST_F(SessionFolder, symbolicLinksInItsFolderAreNotFollowed)
{
    const std::string elsewhere = directory.file("elsewhere.tts"), link = folder + "/link.tts";
    std::filesystem::create_directories(folder);
    ASSERT_TRUE(someSession(elsewhere, 300));  // the writer is destroyed without sealing
    const std::string before = contentOf(elsewhere);
    std::filesystem::create_symlink(elsewhere, link);
    EXPECT_TRUE(sessionsIn(folder).empty());
    const auto told = recoverDeadSessions({link});
    ASSERT_EQ(told.size(), 1U);
    EXPECT_NE(told[0].english().find("is a symbolic link"), std::string::npos) << told[0].english();
    EXPECT_EQ(contentOf(elsewhere), before);
    makeClosed(directory.file("closed.tts"));
    std::filesystem::create_symlink(directory.file("closed.tts"), folder + "/closed.tts");
    EXPECT_EQ(
        applyRetention({folder + "/closed.tts"}, {.days = 1.0, .confirmed = true}, kLater).size(),
        0U);
    EXPECT_TRUE(std::filesystem::exists(folder + "/closed.tts"));
}

TEST_F(SessionFolder, aDamagedJournalIsNamedAndKept)
{
    const std::string live = directory.file("live.tts"), dead = directory.file("dead.tts");
    const auto writer = someSession(live, 300);
    ASSERT_TRUE(writer) << writer.error().text;
    std::filesystem::copy_file(live, dead);
    const std::string garbage(50'000, 'x');
    directory.write("dead.tts-wal", garbage);
    const auto told = recoverDeadSessions({dead});
    ASSERT_EQ(told.size(), 1U);
    EXPECT_NE(told[0].english().find("its journal dead.tts-wal is damaged"), std::string::npos)
        << told[0].english();
    EXPECT_EQ(contentOf(dead + "-wal"), garbage);
}

TEST_F(SessionFolder, isNeverRelative)
{
    const char* const home = std::getenv("HOME");
    const std::string before = home ? home : "";
    ::unsetenv("XDG_STATE_HOME");
    ::setenv("HOME", "/somebody", 1);
    EXPECT_EQ(sessionFolder(), "/somebody/.local/state/terratact/sessions");
    for (const char* const odd : {"", "relative", "."}) {
        ::setenv("HOME", odd, 1);
        EXPECT_TRUE(sessionFolder().empty() || sessionFolder().front() == '/') << odd;
    }
    ::unsetenv("HOME");
    EXPECT_TRUE(sessionFolder().empty() || sessionFolder().front() == '/');
    if (home) ::setenv("HOME", before.c_str(), 1);
}

TEST_F(SessionFolder, anOpenSessionDoesNotCount)
{
    std::filesystem::create_directories(folder);
    auto closed = someSession(folder + "/1.tts", 100);
    ASSERT_TRUE(closed && closed->seal());
    const double one = static_cast<double>(std::filesystem::file_size(folder + "/1.tts"));
    const auto open = someSession(folder + "/2.tts", 20'000);
    ASSERT_TRUE(open);
    EXPECT_EQ(applyRetention(sessionsIn(folder),
                             {.gigabytes = 1e-9 * (one + 1.0), .confirmed = true}, wallNow())
                  .size(),
              0U);
    EXPECT_TRUE(std::filesystem::exists(folder + "/1.tts"));
}

}  // namespace
}  // namespace terratact
