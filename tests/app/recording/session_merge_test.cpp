// Tests which sessions merge, and that a refusal leaves no file.
#include "app/recording/session_merge.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/sessions/session_files.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

constexpr std::int64_t kMergeSecond = 1'000'000'000;

/// Adds frames of the first `count` milliseconds.
auto withFrames(std::int64_t count)
{
    return [count](SessionWriter& writer) {
        for (std::int64_t n = 0; n < count; ++n) ASSERT_TRUE(writer.add(someFrame(n)));
    };
}

TEST_F(SessionFiles, mergeInTheOrderOfTheirFrames)
{
    const std::string later = session("later.tts", withFrames(5), kMergeSecond);
    const std::string first = session("first.tts", withFrames(10));
    const std::string out = directory.file("both.tts");
    const auto merged = mergeSessionFiles({later, first}, out);
    ASSERT_TRUE(merged) << merged.error().text;
    EXPECT_EQ(merged->sessions, 2U);
    EXPECT_EQ(merged->frames, 15);
    auto reader = *SessionReader::open(out);
    const SessionVerification found = reader.verify();
    EXPECT_TRUE(found.damage.empty());
    EXPECT_EQ(merged->chain, found.chain);
    EXPECT_EQ(reader.start().wallTime, someStart().wallTime);
    std::vector<std::string> origins;
    for (const EventRow& event : reader.events())
        if (event.subject == "merged") origins.push_back(event.text);
    ASSERT_EQ(origins.size(), 2U);
    EXPECT_NE(origins[0].find("from first.tts, 10 frames"), std::string::npos) << origins[0];
    EXPECT_NE(origins[1].find("from later.tts, 5 frames"), std::string::npos) << origins[1];
}

TEST_F(SessionFiles, thatDoNotFollowEachOtherDoNotMerge)
{
    const std::string first = session("first.tts", withFrames(10));
    const std::string overlap = session("overlap.tts", withFrames(10), 5'000'000);
    const std::string late = session("late.tts", withFrames(10), 32 * 86'400 * kMergeSecond);
    const std::string out = directory.file("both.tts");
    const auto refusal = [&](const std::string& file) {
        const auto merged = mergeSessionFiles({first, file}, out);
        EXPECT_FALSE(std::filesystem::exists(out));
        return merged ? std::string() : merged.error().text;
    };
    EXPECT_NE(refusal(overlap).find("overlap.tts: begins at "), std::string::npos);
    EXPECT_NE(refusal(late).find("late.tts: was recorded more than a month apart"),
              std::string::npos);
    EXPECT_NE(refusal(directory.file("none.tts")).find("none.tts"), std::string::npos);
}

TEST_F(SessionFiles, ofAnotherRobotOrBusDoNotMerge)
{
    const std::string first = session("first.tts", withFrames(10));
    const std::string out = directory.file("both.tts");
    for (const char* const other : {"robot", "bus"}) {
        SessionStart start = someStart();
        start.wallTime += kMergeSecond;
        if (other == std::string("bus")) {
            start.robot = contentOf(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
            start.bus = "can7";
        }
        const std::string path = directory.file(std::string(other) + ".tts");
        auto writer = SessionWriter::create(path, start);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
        const auto merged = mergeSessionFiles({first, path}, out);
        ASSERT_FALSE(merged) << other;
        EXPECT_NE(merged.error().text.find(other == std::string("bus") ? "can7" : "another robot"),
                  std::string::npos)
            << merged.error().text;
        EXPECT_FALSE(std::filesystem::exists(out));
    }
}

TEST_F(SessionFiles, mergeNeverReplacesAFile)
{
    const std::string first = session("first.tts", withFrames(10));
    const std::string out = session("out.tts", withFrames(1), kMergeSecond);
    const std::string before = contentOf(out);
    EXPECT_FALSE(mergeSessionFiles({first}, out));
    EXPECT_EQ(contentOf(out), before);
}

}  // namespace
}  // namespace terratact
