// Tests decisions on heights while a person makes them.
#include "app/modelling/truth/truth_choices.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

using Kind = TruthDecision::Kind;

/// Four scenes; the third has no heights.
LaserTruth fourScenes()
{
    LaserTruth truth;
    for (const char* run : {"a", "a", "b", "b"}) {
        TwoTrackScene scene;
        scene.run = run;
        truth.tracks.push_back(scene);
    }
    truth.truths.resize(4);
    for (SceneTruth& scene : truth.truths) scene.gap = TruthGap::None;
    truth.truths[2].gap = TruthGap::NoCloud;
    return truth;
}

struct Choices : testing::Test {
    LaserTruth truth = fourScenes();
    TruthChoices choices{truth};
};

TEST_F(Choices, aDecisionHasItsRowAndRun)
{
    EXPECT_EQ(choices.decision(1), nullptr);
    choices.exclude(3);
    choices.accept(1);
    const auto all = choices.decisions();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].row, 2U) << "rows of files count from 1";
    EXPECT_EQ(all[0].run, "a");
    EXPECT_EQ(all[1].run, "b");
    EXPECT_EQ(choices.count(Kind::Accept), 1U);
    EXPECT_EQ(choices.count(Kind::Exclude), 1U);
}

TEST_F(Choices, nudgesAddUpWithinTheirLimits)
{
    for (int i = 0; i < 3; ++i) choices.nudge(0, 0.005, -0.005, 0.02);
    EXPECT_DOUBLE_EQ(choices.decision(0)->offset, 0.015);
    EXPECT_DOUBLE_EQ(choices.decision(0)->tilt, -0.015);
    EXPECT_DOUBLE_EQ(choices.decision(0)->along, 0.06);
    EXPECT_EQ(choices.decision(0)->kind, Kind::Accept);
    choices.nudge(0, 5.0, -5.0, -5.0);
    EXPECT_EQ(choices.decision(0)->offset, kMaxNudge);
    EXPECT_EQ(choices.decision(0)->tilt, -kMaxNudgeTilt);
    EXPECT_EQ(choices.decision(0)->along, -kMaxNudgeAlong);
    choices.exclude(0);
    EXPECT_EQ(choices.decision(0)->offset, kMaxNudge) << "it counts again once accepted";
    choices.removeNudge(0);
    EXPECT_EQ(choices.decision(0)->offset, 0.0);
    EXPECT_EQ(choices.decision(0)->along, 0.0);
    EXPECT_EQ(choices.decision(0)->kind, Kind::Exclude);
}

TEST_F(Choices, undoGoesBackChangeByChange)
{
    EXPECT_FALSE(choices.canUndo());
    EXPECT_FALSE(choices.undo());
    choices.accept(0);
    choices.accept(0);  // changes nothing
    choices.removeNudge(0);
    choices.nudge(1, 0.01, 0.0, 0.0);
    choices.nudge(1, 0.0, 0.0, 0.02);
    choices.exclude(0);
    EXPECT_EQ(choices.undo(), 0U);
    EXPECT_EQ(choices.decision(0)->kind, Kind::Accept);
    EXPECT_EQ(choices.undo(), 1U);
    EXPECT_EQ(choices.decision(1)->along, 0.0);
    EXPECT_EQ(choices.decision(1)->offset, 0.01);
    EXPECT_EQ(choices.undo(), 1U);
    EXPECT_EQ(choices.decision(1), nullptr);
    EXPECT_EQ(choices.undo(), 0U);
    EXPECT_EQ(choices.decision(0), nullptr);
    EXPECT_FALSE(choices.canUndo());
}

TEST_F(Choices, theNextOpenSceneHasHeightsAndNoDecision)
{
    EXPECT_EQ(choices.nextOpen(0), 1U);
    EXPECT_EQ(choices.nextOpen(1), 3U) << "the third has no heights";
    choices.accept(1);
    choices.exclude(3);
    EXPECT_EQ(choices.nextOpen(1), 0U) << "around the end";
    choices.accept(0);
    EXPECT_FALSE(choices.nextOpen(0));
}

TEST_F(Choices, loadingReplacesDecisionsAndForgetsChanges)
{
    choices.exclude(0);
    choices.load({{.row = 2, .kind = Kind::Accept, .offset = 0.01}});
    EXPECT_FALSE(choices.canUndo());
    EXPECT_EQ(choices.decision(0), nullptr);
    ASSERT_TRUE(choices.decision(1));
    EXPECT_EQ(choices.decision(1)->run, "a") << "the run of the row";
}

}  // namespace
}  // namespace terratact
