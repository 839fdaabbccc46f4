// Tests the estimates of a scene: preparation, live previews, the strip, and models.
#include "app/mission/estimation.h"

#include <cmath>
#include <vector>

#include "tests/support/benches/exploration_bench.h"

namespace terratact {
namespace {

/// A robot that stands on an estimate and then drives on.
struct DrivingOn : Bench {
    void stand()
    {
        press();
        ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
        exploration->refuse(exploration->proposal()->id);
        ASSERT_TRUE(reaches(AtemPhase::Presenting));
    }
    void driveBy(double metres)
    {
        telemetry.activity = RobotActivity::Driving;
        const auto steps = static_cast<int>(std::lround(metres / 0.1));
        for (int k = 0; k < steps; ++k) {
            if (telemetry.travelled) *telemetry.travelled += 0.1;
            tick(2);
        }
    }
    HeightBand rememberedAt(double x)
    {
        const SeenStrip seen = exploration->estimation().remembered();
        for (const SeenBin& bin : seen.side[0])
            if (std::abs(bin.x - x) < 1e-6) return bin.band;
        ADD_FAILURE() << "nothing is remembered at " << x;
        return {};
    }
};

TEST_F(DrivingOn, remembersTheGroundBehind)
{
    telemetry.travelled = 7.0;
    stand();
    EXPECT_TRUE(exploration->estimation().estimate());
    driveBy(0.1);
    EXPECT_FALSE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->estimation().verdict()) << "it decides nothing";
    EXPECT_NEAR(rememberedAt(0.3).height, stepEstimate().height[7], 1e-9);
    driveBy(0.3);
    driveBy(0.7);
    EXPECT_NEAR(rememberedAt(-0.6).height, stepEstimate().height[8], 1e-9) << "1.1 m on";
    EXPECT_FALSE(exploration->estimation().whyNothingRemembered());
    telemetry.activity = RobotActivity::Halted;
    press();
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_EQ(exploration->estimation().remembered().side[0].size(), std::size_t{2} * kBins);
}

TEST_F(DrivingOn, withoutOdometryRemembersNothingForAReason)
{
    stand();
    driveBy(0.1);
    EXPECT_FALSE(exploration->estimation().estimate());
    EXPECT_TRUE(exploration->estimation().remembered().isEmpty());
    EXPECT_TRUE(mentions(exploration->estimation().whyNothingRemembered(), "no odometry"));
}

TEST_F(DrivingOn, showsNothingRememberedWhileTheLinkIsLost)
{
    telemetry.travelled = 0.0;
    stand();
    driveBy(0.1);
    tickInSilence(10);
    EXPECT_TRUE(exploration->estimation().remembered().isEmpty());
    EXPECT_TRUE(mentions(exploration->estimation().whyNothingRemembered(),
                         "No remembered ground while telemetry is missing"));
    tick();
    EXPECT_FALSE(exploration->estimation().remembered().isEmpty());
    telemetry.time += 2.0;  // two seconds of silence
    tick();
    EXPECT_TRUE(exploration->estimation().remembered().isEmpty());
    EXPECT_TRUE(mentions(exploration->estimation().whyNothingRemembered(), "may have moved"));
    tickInSilence(10);
    EXPECT_TRUE(mentions(exploration->estimation().whyNothingRemembered(), "may have moved"))
        << "it is ended for that, not for the silence of now";
}

TEST_F(DrivingOn, remembersNothingBehindASuspectedPitch)
{
    telemetry.travelled = 0.0;
    stand();
    driveBy(0.1);
    ASSERT_FALSE(exploration->estimation().remembered().isEmpty());
    suspicions = {{.sensor = Sensor::Pitch}};
    driveBy(0.1);
    EXPECT_TRUE(exploration->estimation().remembered().isEmpty());
    EXPECT_TRUE(mentions(exploration->estimation().whyNothingRemembered(), "is suspected"));
    suspicions.clear();
    driveBy(0.1);
    EXPECT_TRUE(exploration->estimation().remembered().isEmpty()) << "nothing is joined over it";
    telemetry.activity = RobotActivity::Halted;
    press();
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_FALSE(exploration->estimation().remembered().isEmpty());
}

TEST_F(DrivingOn, aClearedEstimateIsNotRemembered)
{
    telemetry.travelled = 0.0;
    stand();
    exploration->abort();
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    driveBy(0.1);
    EXPECT_TRUE(exploration->estimation().remembered().isEmpty());
    EXPECT_FALSE(exploration->estimation().whyNothingRemembered());
}

TEST_F(DrivingOn, aRestoredEstimateIsRememberedAgain)
{
    telemetry.travelled = 0.0;
    stand();
    exploration->forgetResult();
    tick();
    EXPECT_TRUE(exploration->estimation().remembered().isEmpty());
    exploration->restoreResult();
    tick();
    EXPECT_FALSE(exploration->estimation().remembered().isEmpty());
}

TEST_F(DrivingOn, rememberedGroundCanBeCleared)
{
    telemetry.travelled = 0.0;
    stand();
    driveBy(0.1);
    ASSERT_FALSE(exploration->estimation().remembered().isEmpty());
    exploration->forgetResult();
    tick();
    EXPECT_TRUE(exploration->estimation().remembered().isEmpty());
    EXPECT_TRUE(mentions(exploration->estimation().whyNothingRemembered(), "was cleared"));
}

/// A robot whose arm has measured a bin, and that presses again.
struct PressingAgain : Bench {
    const ArmReading reading{.bin = kBin06, .height = -0.04, .sd = 0.03};

    void probe()
    {
        telemetry.travelled = 1.0;
        telemetry.turned = 0.0;
        ASSERT_NO_FATAL_FAILURE(propose());
        exploration->approve(exploration->proposal()->id);
        ASSERT_TRUE(reaches(AtemPhase::Probing));
        telemetry.activity = RobotActivity::Probing;
        tick(3);
        telemetry.activity = RobotActivity::Pressed;
        telemetry.arm = reading;
        ASSERT_TRUE(reaches(AtemPhase::Presenting));
        telemetry.activity = RobotActivity::Halted;
        telemetry.arm.reset();
        tick(3);
    }
    /// Returns the readings that count for the estimate after the next press.
    std::vector<ArmReading> readingsAfterAPress()
    {
        press();
        EXPECT_TRUE(reaches(AtemPhase::Estimating));
        return exploration->estimation().readings();
    }
};

TEST_F(PressingAgain, inPlaceKeepsTheArmsReading)
{
    ASSERT_NO_FATAL_FAILURE(probe());
    EXPECT_EQ(readingsAfterAPress(), std::vector{reading});
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return exploration->estimation().estimate().has_value();
    }));
    EXPECT_EQ(exploration->estimation().estimate()->side[0].origin[kBin06], Origin::Arm);
    EXPECT_EQ(exploration->estimation().ledger().entries().size(), 1U) << "it is scored once";
}

TEST_F(PressingAgain, elsewhereBeginsWithoutAReading)
{
    ASSERT_NO_FATAL_FAILURE(probe());
    *telemetry.travelled += 0.04;
    EXPECT_TRUE(readingsAfterAPress().empty());
}

TEST_F(PressingAgain, tiltedBeginsWithoutAReading)
{
    ASSERT_NO_FATAL_FAILURE(probe());
    telemetry.pitch += 0.03;
    EXPECT_TRUE(readingsAfterAPress().empty());
}

TEST_F(PressingAgain, turnedBeginsWithoutAReading)
{
    ASSERT_NO_FATAL_FAILURE(probe());
    *telemetry.turned += 0.06;
    EXPECT_TRUE(readingsAfterAPress().empty());
}

TEST_F(PressingAgain, underSuspicionBeginsWithoutAReading)
{
    ASSERT_NO_FATAL_FAILURE(probe());
    suspicions = {{.sensor = Sensor::Force1}};
    EXPECT_TRUE(readingsAfterAPress().empty());
}

TEST_F(Bench, telemetryIsEstimatedLiveWhileTheFlippersMove)
{
    exploration->request();
    telemetry.activity = RobotActivity::Halted;
    EXPECT_FALSE(exploration->estimation().live());
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.activity = RobotActivity::Pressing;
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return estimates >= 5;
    }));
    ASSERT_TRUE(exploration->estimation().live());
    EXPECT_EQ(exploration->estimation().live()->side[0].settings.method, Method::Local);
    EXPECT_FALSE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->proposal()) << "a preview proposes nothing";

    blocked = true;
    telemetry.activity = RobotActivity::Pressed;
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    EXPECT_TRUE(exploration->estimation().live()) << "stays until there is better";
    blocked = false;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_TRUE(exploration->estimation().estimate());
    EXPECT_FALSE(exploration->estimation().live());
}

TEST_F(Bench, samplersGaussianProcessesArePreparedWhenIdle)
{
    tick(3);
    EXPECT_EQ(estimates, 0) << "a formula needs none";
    Settings sampled;
    sampled.method = Method::Pafc;
    exploration->setSettings(sampled);
    const auto isMade = [this](int made) {
        return gui::eventually([&] {
            tick();
            return estimates == made && settles();
        });
    };
    ASSERT_TRUE(isMade(1));
    EXPECT_EQ(lastAsked().settings.method, Method::Pafc);
    EXPECT_TRUE(lastAsked().prepares);
    EXPECT_FALSE(exploration->estimation().estimate()) << "nobody has asked for an estimate";
    tick(5);
    EXPECT_EQ(estimates, 1) << "once is enough";
    sampled.inducing = 300;
    exploration->setSettings(sampled);
    ASSERT_TRUE(isMade(2)) << "those of other settings";
    exploration->setSecondMethod(Method::Pa);
    ASSERT_TRUE(isMade(3)) << "those of the second method";
    EXPECT_EQ(lastAsked().settings.method, Method::Pa);
    EXPECT_TRUE(lastAsked().prepares);
    ASSERT_TRUE(begunToPress());
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return exploration->estimation().live().has_value();
    }));
    EXPECT_EQ(lastAsked().settings.method, Method::Local) << "nor again while the flippers move";
}

TEST_F(Bench, samplersPrepareOnceWhileTheFlippersMove)
{
    Settings sampled;
    sampled.method = Method::Pafc;
    sampled.inducing = 300;
    exploration->setSettings(sampled);
    blocked = true;
    ASSERT_TRUE(begunToPress());
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return estimates == 1;
    }));
    EXPECT_EQ(lastAsked().settings.method, Method::Pafc);
    EXPECT_EQ(lastAsked().settings.inducing, 300);
    EXPECT_TRUE(lastAsked().prepares);
    tick(5);
    EXPECT_EQ(estimates, 1) << "no preview overtakes it";
    blocked = false;
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return exploration->estimation().live().has_value();
    }));
    EXPECT_EQ(exploration->estimation().live()->side[0].settings.method, Method::Local)
        << "it shows nothing";

    const int before = estimates;
    ASSERT_TRUE(gui::eventually([&] {
        tick();
        return estimates >= before + 3;
    }));
    EXPECT_EQ(lastAsked().settings.method, Method::Local) << "once is enough";
    telemetry.activity = RobotActivity::Pressed;
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    EXPECT_EQ(exploration->estimation().estimate()->side[0].settings.method, Method::Pafc);
}

TEST_F(Bench, secondMethodIsNotPreparedWhileFlippersMove)
{
    exploration->setSecondMethod(Method::Pafc);
    blocked = true;
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return estimates == 1;
    }));
    EXPECT_TRUE(lastAsked().prepares);
    ASSERT_TRUE(begunToPress());
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return estimates == 2;
    })) << "no preview overtakes them";
    EXPECT_EQ(lastAsked().settings.method, Method::Local);
    blocked = false;
}

TEST_F(Bench, aLivePreviewEndsWithTheExploration)
{
    ASSERT_TRUE(begunToPress());
    ASSERT_TRUE(gui::eventually([this] {
        tick();
        return exploration->estimation().live().has_value();
    }));
    blocked = true;
    const int before = estimates;
    ASSERT_TRUE(gui::eventually([&] {
        tick();
        return estimates > before;
    }));
    ASSERT_TRUE(answerIsQueued());
    exploration->abort();
    tick();
    EXPECT_FALSE(exploration->estimation().live());
    QCoreApplication::processEvents();
    EXPECT_FALSE(exploration->estimation().live()) << "a preview already on its way is not shown";
}

TEST_F(Bench, modelChosenDuringAnEstimateIsUsedForIt)
{
    ASSERT_NO_FATAL_FAILURE(beginToEstimate());
    worker->load([this]() -> Result<LoadedModel> {
        return LoadedModel{
            .estimate = [this](const EstimateRequest& r, const Watch& w) { return estimate(r, w); },
            .name = "other.ttm",
            .details = {}};
    });
    ASSERT_TRUE(gui::eventually([this] { return events.contains("model other.ttm loaded"); }));
    blocked = false;
    EXPECT_TRUE(reaches(AtemPhase::ProposingProbe))
        << describe(exploration->state().failure).english;
}

TEST_F(Bench, estimateContinuesIfTheNewModelCannotBeLoaded)
{
    blocked = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Estimating));
    worker->load([]() -> Result<LoadedModel> { return Error{"no such file"}; });
    blocked = false;
    EXPECT_TRUE(reaches(AtemPhase::ProposingProbe))
        << describe(exploration->state().failure).english;
}

TEST_F(Bench, aFailedEstimateIsReportedAsText)
{
    broken = true;
    press();
    ASSERT_TRUE(reaches(AtemPhase::Failed));
    EXPECT_EQ(exploration->state().failure, AtemFailure::EstimateError);
    EXPECT_TRUE(events.join('\n').contains("covariance is not positive definite"));
}

TEST_F(Bench, sceneIsTheFirstPressedSampleHoweverLateThePoll)
{
    exploration->request();
    tick();
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.activity = RobotActivity::Pressing;
    tick(3);
    telemetry.activity = RobotActivity::Pressed;
    telemetry.pitch = 0.011;
    line();
    telemetry.pitch = 0.012;
    line();
    tick();
    ASSERT_EQ(phase(), AtemPhase::Estimating);
    EXPECT_EQ(exploration->estimation().scene()->measurement.pitch, 0.011);
}

TEST_F(Bench, aPressFromBeforeTheCommandIsNoScene)
{
    telemetry.activity = RobotActivity::Pressed;
    telemetry.pitch = 0.011;
    tick(3);
    exploration->request();
    ASSERT_TRUE(reaches(AtemPhase::Pressing));
    telemetry.pitch = 0.012;
    ASSERT_TRUE(reaches(AtemPhase::Estimating)) << "it was pressed again between two lines";
    EXPECT_EQ(exploration->estimation().scene()->measurement.pitch, 0.012);
}

}  // namespace
}  // namespace terratact
