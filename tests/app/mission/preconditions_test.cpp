// Tests the preconditions of exploring and of the other commands, and overriding doubtful ones.

#include "app/display/translated.h"
#include "tests/support/absolem.h"
#include "tests/support/benches/exploration_bench.h"

namespace terratact {
namespace {

struct PreconditionBench : Bench {
    QString overridden() const
    {
        return translated(Message::listed(exploration->overridden(), "; "));
    }
};

TEST_F(PreconditionBench, unmetPreconditionsOfAnExplorationAreListed)
{
    using Level = Precondition::Level;
    const auto level = [this](const QString& words) {
        for (const Precondition& p : exploration->preconditions())
            if (translated(p.text).contains(words)) return static_cast<int>(p.level);
        return -1;
    };
    EXPECT_EQ(level("telemetry"), static_cast<int>(Level::Met));
    telemetry.roll = 0.2;
    tick();
    EXPECT_EQ(level("roll"), static_cast<int>(Level::Doubtful));
    exploration->overrideWarnings();
    EXPECT_EQ(level("roll"), static_cast<int>(Level::Overridden));
    EXPECT_TRUE(overridden().contains("roll"));
    EXPECT_TRUE(events.filter("overridden by the operator").size() == 1) << "it is logged";
    telemetry.roll = 0.0;
    tick();
    EXPECT_TRUE(overridden().isEmpty()) << "an override must not outlive its reason";
    exploration->overrideWarnings();
    EXPECT_TRUE(overridden().isEmpty()) << "nor come before it";
    telemetry.rearLeft = 0.4;
    tick();
    EXPECT_EQ(level("flippers differ"), static_cast<int>(Level::Doubtful));
    tickInSilence(10);
    EXPECT_EQ(level("telemetry"), static_cast<int>(Level::Missing));
}

TEST_F(PreconditionBench, nothingMovesWhileTheArmIsOutAfterAnAbort)
{
    telemetry.activity = RobotActivity::Probing;
    tick();
    const QString out = "✘ the arm is still out: wait until it is back, or press STOP";
    EXPECT_TRUE(linesOf(exploration->preconditions()).contains(out));
    EXPECT_TRUE(linesOf(exploration->toDrive()).contains(out));
    exploration->request();
    exploration->drive(1);
    tick();
    EXPECT_EQ(exploration->state().phase, AtemPhase::Idle);
    EXPECT_EQ(sent<DriveCommand>(), 0);
    telemetry.activity = RobotActivity::Halted;
    tick();
    EXPECT_FALSE(linesOf(exploration->preconditions()).contains("✘"));
    exploration->request();
    tick();
    EXPECT_NE(exploration->state().phase, AtemPhase::Idle);
}

TEST_F(PreconditionBench, beyondTheTipOverAngleNothingIsExplored)
{
    Exploration heavy(source, absolem(), *worker, Exploration::Options{});
    const auto phaseAfterRequest = [&](double pitch) {
        telemetry.pitch = pitch;
        tick();
        heavy.tick({.now = now, .latest = latest});
        heavy.request();
        heavy.tick({.now = now, .latest = latest});
        return heavy.state().phase;
    };
    const QString tipped = "✘ pitch or roll is beyond the tip-over angle";
    EXPECT_EQ(phaseAfterRequest(1.4), AtemPhase::Idle);
    EXPECT_TRUE(linesOf(heavy.preconditions()).contains(tipped));
    EXPECT_FALSE(linesOf(heavy.toDrive()).contains(tipped)) << "driving back may help";
    EXPECT_NE(phaseAfterRequest(0.0), AtemPhase::Idle);
    EXPECT_FALSE(linesOf(heavy.preconditions()).contains(tipped));
}

TEST_F(PreconditionBench, robotConditionsAreUnmetWithoutTelemetry)
{
    EXPECT_EQ(linesOf(exploration->preconditions()),
              "✔ telemetry is live\n✔ STOP is not latched\n✔ model fake.ttm is ready\n"
              "✔ left and right agree, roll is small");
    exploration->tick({.now = now + 0.849, .latest = latest});
    const QString stale = "✘ no telemetry from the robot\n"
                          "! STOP: not known, no telemetry\n"
                          "✔ model fake.ttm is ready\n! left, right: not known, no telemetry";
    EXPECT_EQ(linesOf(exploration->preconditions()), stale);
    EXPECT_TRUE(linesOf(exploration->toDrive()).startsWith("! STOP: not known"));

    telemetry.roll = 0.2;
    tick();
    exploration->tick({.now = now + 0.849, .latest = latest});
    exploration->overrideWarnings();
    EXPECT_EQ(overridden(), "") << "of a roll that was, nobody can take anything upon him";
    EXPECT_EQ(linesOf(exploration->preconditions()), stale);
    tick();
    EXPECT_TRUE(linesOf(exploration->preconditions()).contains("! roll +11.5°"));

    Exploration unheard(source, RobotModel{}, *worker, Exploration::Options{});
    unheard.tick({.now = now});
    EXPECT_FALSE(linesOf(unheard.preconditions()).contains("✔ STOP"));
    EXPECT_TRUE(linesOf(unheard.preconditions()).contains("! left, right: not known"));
}

TEST_F(PreconditionBench, anOverrideCoversOneReasonAtItsSize)
{
    using Level = Precondition::Level;
    const auto levels = [this](Level level) {
        int count = 0;
        for (const Precondition& p : exploration->preconditions()) count += p.level == level;
        return count;
    };
    telemetry.roll = 0.105;  // 6°
    tick();
    exploration->overrideWarnings();
    EXPECT_EQ(overridden(), "roll +6.0°: left and right ground differ");
    telemetry.roll = 0.15;
    tick();
    EXPECT_EQ(levels(Level::Overridden), 1) << "as good as the same";
    EXPECT_TRUE(overridden().contains("6.0°")) << "what was overridden then";

    telemetry.rearLeft = 0.4;
    tick();
    EXPECT_EQ(levels(Level::Overridden), 1);
    EXPECT_EQ(levels(Level::Doubtful), 1) << "nobody has overridden the flippers";
    exploration->overrideWarnings();
    EXPECT_EQ(events.filter("overridden by the operator").size(), 2) << "each once";
    EXPECT_EQ(levels(Level::Overridden), 2);

    telemetry.roll = 0.52;  // 30°
    tick();
    EXPECT_EQ(levels(Level::Doubtful), 1);
    EXPECT_FALSE(overridden().contains("roll"));
    EXPECT_TRUE(overridden().contains("flippers"));
    EXPECT_EQ(events.filter("the override has ended: roll +29.8°").size(), 1);
}

TEST_F(PreconditionBench, aTurnedDifferentialNeedsAnOverride)
{
    telemetry.differential = 0.019;  // [rad] within its sensor's noise
    tick();
    EXPECT_TRUE(linesOf(exploration->preconditions()).contains("✔ left and right agree"));
    telemetry.differential = 0.1;
    tick();
    EXPECT_TRUE(linesOf(exploration->preconditions())
                    .contains("! the track differential has turned by +5.7°"));
    exploration->overrideWarnings();
    EXPECT_EQ(overridden(), "the track differential has turned by +5.7°");
    telemetry.differential = 0.0;
    tick();
    EXPECT_EQ(events.filter("the override has ended: the track differential is back").size(), 1);
}

TEST_F(PreconditionBench, overrideEndsWhenItsReasonEndsWhileExploring)
{
    telemetry.roll = 0.105;
    tick();
    exploration->overrideWarnings();
    exploration->request();
    tick();
    ASSERT_EQ(phase(), AtemPhase::Halting);
    telemetry.roll = 0.0;
    tick();
    EXPECT_EQ(overridden(), "");
    EXPECT_EQ(events.filter("the override has ended: the roll is small again").size(), 1);
}

}  // namespace
}  // namespace terratact
