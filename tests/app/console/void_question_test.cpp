// Tests void proposals: after its basis changed, only a new exploration gives a valid one.
#include "app/display/precondition.h"
#include "core/atem/atem_machine.h"
#include "tests/support/benches/exploration_bench.h"

namespace terratact {
namespace {

struct VoidQuestion : Bench {
    VoidQuestion()
    {
        withDraws = true;  // draws give the other bins a worth
        press();
        EXPECT_TRUE(reaches(AtemPhase::ProposingProbe));
    }
    void loadAnotherModel()
    {
        worker->load([this]() -> Result<LoadedModel> {
            return LoadedModel{.estimate = [this](const EstimateRequest& r,
                                                  const Watch& w) { return estimate(r, w); },
                               .name = "other.ttm",
                               .details = {}};
        });
        ASSERT_TRUE(gui::eventually(
            [this] { return exploration->estimation().model().name == "other.ttm"; }));
        tick(3);
        ASSERT_EQ(phase(), AtemPhase::ProposingProbe) << "it is still on the screen";
    }
    bool mayBeApproved() const { return !firstMissing(exploration->toProbe()); }
};

TEST_F(VoidQuestion, isSaidToBe)
{
    EXPECT_TRUE(mayBeApproved());
    loadAnotherModel();
    EXPECT_FALSE(mayBeApproved());
}

TEST_F(VoidQuestion, changedSettingsVoidItUntilTheyAreRestored)
{
    const Settings then = exploration->options().settings;
    Settings others = then;
    others.forceThreshold += 0.5;
    exploration->setSettings(others);
    tick(3);
    EXPECT_FALSE(mayBeApproved());
    exploration->setSettings(then);
    tick(3);
    EXPECT_TRUE(mayBeApproved());
    exploration->setSettings(others);
    exploration->approve(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Failed));
    EXPECT_EQ(exploration->state().failure, AtemFailure::ApprovalVoid);
    EXPECT_EQ(sent<ProbeCommand>(), 0);
}

TEST_F(VoidQuestion, isNotRevivedByAskingForAnotherBin)
{
    ASSERT_FALSE(exploration->proposal()->others.empty());
    const quint64 id = exploration->proposal()->id;
    const int other = exploration->proposal()->others.front().bin;
    loadAnotherModel();
    exploration->choose(id, {other});
    tick(3);
    EXPECT_EQ(exploration->proposal()->id, id);
    EXPECT_FALSE(mayBeApproved());
}

TEST_F(VoidQuestion, isNotRevivedByAnotherLimit)
{
    loadAnotherModel();
    exploration->setStepLimit(0.2);
    ASSERT_TRUE(settles());
    tick(3);
    EXPECT_FALSE(mayBeApproved());
}

TEST_F(VoidQuestion, mayStillBeRefused)
{
    loadAnotherModel();
    exploration->refuse(exploration->proposal()->id);
    EXPECT_TRUE(reaches(AtemPhase::Presenting));
}

TEST_F(VoidQuestion, approvingItFailsTheExploration)
{
    loadAnotherModel();
    exploration->approve(exploration->proposal()->id);
    EXPECT_TRUE(reaches(AtemPhase::Failed));
    EXPECT_EQ(exploration->state().failure, AtemFailure::ApprovalVoid);
    EXPECT_EQ(sent<ProbeCommand>(), 0);
}

}  // namespace
}  // namespace terratact
