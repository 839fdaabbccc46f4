#include "app/modelling/session_reruns.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const std::string kDemo = TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts";

TEST(SessionReruns, aFolderGivesItsSessionsSortedByName)
{
    const TemporaryDirectory folder;
    for (const char* name : {"b.tts", "a.tts", "notes.txt"})
        std::ofstream(folder.file(name)) << "x";
    EXPECT_EQ(sessionsAt(folder.file("")),
              (std::vector<std::string>{folder.file("a.tts"), folder.file("b.tts")}));
    EXPECT_EQ(sessionsAt(folder.file("notes.txt")),
              std::vector<std::string>{folder.file("notes.txt")})
        << "a file is read, whatever its name";
}

TEST(SessionReruns, errorsNameTheFile)
{
    SessionReruns reruns({}, {});
    const Status missing = reruns.add("no-such.tts");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().text.find("no-such.tts"), std::string::npos);
}

TEST(SessionReruns, refusesAnEstimateThatDoesNotExist)
{
    int opened = 0;
    SessionReruns counting({.estimate = 999'999'999, .shippedModels = {}, .model = {}},
                           {.opened = [&](const SessionReader&) { ++opened; }, .watch = {}});
    const Status none = counting.add(kDemo);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text.find("has no estimate 999999999"), std::string::npos)
        << none.error().text;
    EXPECT_EQ(opened, 1);
    EXPECT_TRUE(counting.all().empty());
}

TEST(SessionReruns, aMissingModelLeavesNoRerun)
{
    SessionReruns reruns({.estimate = 0,
                          .shippedModels = {TERRATACT_SOURCE_DIR "/no-such.ttm"},
                          .model = TERRATACT_SOURCE_DIR "/no-such.ttm"},
                         {});
    const Status none = reruns.add(kDemo);
    ASSERT_FALSE(none) << "the model cannot be read";
    EXPECT_TRUE(reruns.all().empty());
    EXPECT_EQ(reruns.failed(), 0U);
}

TEST(SessionReruns, theSessionOfTwoTracksIsReproduced)
{
    SessionReruns reruns({.estimate = 0,
                          .shippedModels = {TERRATACT_SOURCE_DIR "/resources/models/default.ttm"},
                          .model = {}},
                         {});
    const Status done = reruns.add(TERRATACT_SOURCE_DIR "/resources/sessions/two_tracks.tts");
    ASSERT_TRUE(done) << done.error().text;
    ASSERT_EQ(reruns.all().size(), 2U);
    for (const Rerun& rerun : reruns.all()) {
        EXPECT_TRUE(rerun.asRecorded);
        EXPECT_FALSE(rerun.failed());
        EXPECT_FALSE(rerun.differences.onePlane);
        EXPECT_NE(rerun.again.side[0].height, rerun.again.side[1].height);
        EXPECT_NE(rerun.differences.after.side[1].stepVerdict, StepVerdict::Blocked);
    }
    const auto left = [&](std::size_t estimate) {
        return reruns.all()[estimate].differences.after.side[0].stepVerdict;
    };
    EXPECT_EQ(left(0), StepVerdict::CannotTell);
    EXPECT_EQ(left(1), StepVerdict::Blocked) << "the arm found the kerb's foot on the left side";
    ASSERT_EQ(reruns.all()[1].row.readings.size(), 1U);
    EXPECT_EQ(reruns.all()[1].row.readings[0].side, ProbeSide::Left);
    EXPECT_EQ(reruns.errors().now.size(), 44U) << "the truth of both sides is known";
    EXPECT_EQ(reruns.laterProbes(*reruns.sessions()[0]).now.entries().size(), 1U);
}

TEST(SessionReruns, onlyTrailNeedsTheNetworks)
{
    const TemporaryDirectory folder;
    const std::string model = folder.file("default.ttm");
    std::filesystem::copy_file(TERRATACT_SOURCE_DIR "/resources/models/default.ttm", model);
    std::ofstream(folder.file("default.ttn")) << "no networks";
    const auto rerunBy = [&](Method method) {
        SessionReruns reruns(
            {.estimate = 1, .shippedModels = {}, .model = model, .changes = {.method = method}},
            {});
        return reruns.add(TERRATACT_SOURCE_DIR "/resources/sessions/two_tracks.tts");
    };
    const Status local = rerunBy(Method::Local);
    EXPECT_TRUE(local) << local.error().text;
    const Status trail = rerunBy(Method::Trail);
    ASSERT_FALSE(trail);
    EXPECT_NE(trail.error().text.find("default.ttn"), std::string::npos) << trail.error().text;
}

TEST(SessionReruns, failsOnlyIfNothingExplainsADifference)
{
    Rerun rerun;
    rerun.asRecorded = true;
    rerun.differences.match = Match::Other;
    EXPECT_TRUE(rerun.failed());
    rerun.differences.match = Match::LastBits;
    EXPECT_FALSE(rerun.failed());
    rerun.differences.match = Match::Other;
    rerun.row.estimate.side[0].ending = Ending::Time;
    EXPECT_FALSE(rerun.failed()) << "time ended the recorded sampling";
    rerun.row.estimate.side[0].ending = {};
    rerun.asRecorded = false;
    EXPECT_FALSE(rerun.failed()) << "a change was requested";
}

}  // namespace
}  // namespace terratact
