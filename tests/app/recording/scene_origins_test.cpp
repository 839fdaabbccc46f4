// Tests that a scene in two files of one recording counts once.
#include "app/recording/scene_origins.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct OriginsOfScenes : testing::Test {
    /// Writes a session with scenes at these times [ns] after its start.
    SessionReader session(const std::string& name, std::initializer_list<SessionTime> times,
                          std::int64_t laterBy = 0)
    {
        SessionStart start = someStart();
        start.wallTime += laterBy;
        auto writer = SessionWriter::create(directory.file(name), start);
        EXPECT_TRUE(writer);
        std::int64_t id = 0;
        for (const SessionTime time : times) EXPECT_TRUE(writer->add(someScene(++id, time)));
        EXPECT_TRUE(writer->seal());
        return *SessionReader::open(directory.file(name));
    }
    using Ids = std::set<std::int64_t>;
    TemporaryDirectory directory;
    SceneOrigins origins;
};

TEST_F(OriginsOfScenes, scenesOfAnEarlierFileAreRepeated)
{
    EXPECT_EQ(origins.add(session("1.tts", {1'000})), Ids{});
    EXPECT_EQ(origins.add(session("2.tts", {1'000, 2'000})), Ids{1});
    EXPECT_EQ(origins.add(session("copy.tts", {1'000, 2'000})), (Ids{1, 2}));
}

TEST_F(OriginsOfScenes, timesCountSince1970)
{
    EXPECT_EQ(origins.add(session("1.tts", {5'000})), Ids{});
    EXPECT_EQ(origins.add(session("later.tts", {4'000}, 1'000)), Ids{1}) << "the same time";
    EXPECT_EQ(origins.add(session("other.tts", {5'000}, 1'000)), Ids{});
}

}  // namespace
}  // namespace terratact
