// Tests that merged sessions hold every row once, with its references.
#include "app/recording/session_merger.h"

#include <gtest/gtest.h>

#include "app/recording/session_merge.h"
#include "tests/support/sessions/session_files.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

TEST_F(SessionFiles, rotatedFilesMergeWithoutDuplicateRows)
{
    const auto row = [](std::int64_t id, SessionTime time) {
        return id == 1 ? someEstimate(1, time) : someSides(id, time);
    };
    const std::string first = session("1.tts", [&](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
        ASSERT_TRUE(writer.add(someFrame(0)));
        ASSERT_TRUE(writer.add(someScene(1, 5'000'000)));
        ASSERT_TRUE(writer.add(row(1, 6'000'000)));
        ASSERT_TRUE(writer.add(someFrame(10)));
    });
    const std::string second = session("2.tts", [&](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
        ASSERT_TRUE(writer.add(someScene(1, 5'000'000)));
        ASSERT_TRUE(writer.add(row(1, 6'000'000)));
        ASSERT_TRUE(writer.add(someFrame(20)));
        ASSERT_TRUE(writer.add(someProposal(21'000'000)));
        EventRow decision = someDecision(22'000'000);
        ASSERT_TRUE(writer.add(decision));
        ASSERT_TRUE(writer.add(someScene(4, 30'000'000)));
        EstimateRow again = row(7, 31'000'000);
        again.scene = 4;
        ASSERT_TRUE(writer.add(again));
    });
    const std::string out = directory.file("whole.tts");
    const auto merged = mergeSessionFiles({second, first}, out);
    ASSERT_TRUE(merged) << merged.error().text;
    auto reader = *SessionReader::open(out);
    EXPECT_TRUE(reader.verify().damage.empty());
    EXPECT_EQ(reader.frameCount(), 3);
    EXPECT_EQ(reader.models().size(), 1U);
    ASSERT_EQ(reader.scenes().size(), 2U);
    ASSERT_EQ(reader.estimates().size(), 2U);
    EXPECT_EQ(reader.estimates()[1].scene, 2);
    EXPECT_EQ((*reader.draws(2))[1], someSides(7, 0).estimate.side[1].draws);
    EXPECT_FALSE(reader.estimates()[1].estimate.onePlane);
    ASSERT_EQ(reader.proposals().size(), 1U);
    const EventRow& decision = reader.events().back();
    EXPECT_EQ(decision.kind, EventKind::Decision);
    EXPECT_EQ(decision.proposal, 1);
    EXPECT_EQ(decision.estimate, 1);
}

}  // namespace
}  // namespace terratact
