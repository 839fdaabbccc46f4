#include "core/atem/phase_time.h"

#include <gtest/gtest.h>

#include <limits>

namespace terratact {
namespace {

using Kind = PhaseTime::Kind;

std::optional<PhaseTime> after(double seconds, AtemPhase phase, const UsualTimes& usual = {})
{
    return phaseTime({.phase = phase, .since = 100.0}, 100.0 + seconds, AtemLimits{}, usual);
}

TEST(PhaseTime, showsTheUsualTimeUntilItHasPassed)
{
    const UsualTimes usual{.press = 4.0, .probe = 45.0};
    EXPECT_EQ(after(0.0, AtemPhase::Probing, usual), (PhaseTime{Kind::Expected, 45.0}));
    EXPECT_EQ(after(33.0, AtemPhase::Probing, usual), (PhaseTime{Kind::Expected, 12.0}));
    EXPECT_EQ(after(50.0, AtemPhase::Probing, usual), (PhaseTime{Kind::GivesUp, 40.0}));
    EXPECT_EQ(after(1.0, AtemPhase::Pressing, usual), (PhaseTime{Kind::Expected, 3.0}));
    EXPECT_EQ(after(5.0, AtemPhase::Pressing, usual), (PhaseTime{Kind::GivesUp, 10.0}));
    EXPECT_EQ(after(5.0, AtemPhase::Halting, usual), std::nullopt) << "its time is over";
}

TEST(PhaseTime, showsATimeLimitOnlyAfterASecond)
{
    for (const AtemPhase phase : {AtemPhase::Halting, AtemPhase::Pressing, AtemPhase::Estimating,
                                  AtemPhase::EstimatingAgain}) {
        EXPECT_EQ(after(0.5, phase), std::nullopt);
        ASSERT_TRUE(after(1.5, phase));
        EXPECT_EQ(after(1.5, phase)->kind, Kind::GivesUp);
    }
    EXPECT_EQ(after(1.5, AtemPhase::Estimating)->seconds, 28.5);
}

TEST(PhaseTime, showsTheApprovalExpiryFromTheStart)
{
    EXPECT_EQ(after(0.0, AtemPhase::ProposingProbe), (PhaseTime{Kind::Answer, 30.0}));
}

TEST(PhaseTime, isEmptyWithoutADeadline)
{
    for (const AtemPhase phase :
         {AtemPhase::Idle, AtemPhase::Presenting, AtemPhase::Stopped, AtemPhase::Failed})
        EXPECT_EQ(after(2.0, phase, {.press = 4.0, .probe = 45.0}), std::nullopt);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(after(nan, AtemPhase::Pressing, {.press = 4.0, .probe = {}}), std::nullopt);
}

}  // namespace
}  // namespace terratact
