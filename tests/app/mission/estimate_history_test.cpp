// Tests the list of a run's estimates.
#include "app/mission/estimate_history.h"

#include "tests/support/benches/exploration_bench.h"

namespace terratact {
namespace {

TEST_F(Bench, historyHasEveryEstimateNewestFirst)
{
    const EstimateHistory history(*exploration);
    EXPECT_EQ(history.present(), 0);
    ASSERT_NO_FATAL_FAILURE(propose());
    ASSERT_EQ(history.entries().size(), 1U);
    const PastEstimate& first = history.entries().front();
    EXPECT_EQ(first.number, 1);
    EXPECT_EQ(history.present(), 1);
    EXPECT_FALSE(first.hasReading);
    EXPECT_TRUE(first.estimate->side[0].draws.empty()) << "draws would take the memory";
    EXPECT_EQ(first.estimate->side[0].height, exploration->estimation().estimate()->side[0].height);
    ASSERT_TRUE(first.verdict);
    EXPECT_EQ(describe(*first.verdict), describe(*exploration->estimation().verdict()));
    EXPECT_EQ(history.entry(2), nullptr);
    EXPECT_EQ(history.entry(1), &first);
}

TEST_F(Bench, aHiddenAndRestoredEstimateIsMarkedAsFromBefore)
{
    const EstimateHistory history(*exploration);
    ASSERT_NO_FATAL_FAILURE(propose());
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    exploration->forgetResult();
    ASSERT_EQ(history.entries().size(), 1U);
    EXPECT_TRUE(history.entries()[0].isHidden);
    EXPECT_EQ(history.present(), 0);
    tick();
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    ASSERT_TRUE(exploration->canRestore());
    exploration->restoreResult();
    ASSERT_EQ(history.entries().size(), 1U) << "it is no new estimate";
    EXPECT_FALSE(history.entries()[0].isHidden);
    EXPECT_TRUE(history.entries()[0].isRestored);
    EXPECT_EQ(history.present(), 1);
}

}  // namespace
}  // namespace terratact
