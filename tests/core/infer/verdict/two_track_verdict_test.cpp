#include "core/infer/verdict/two_track_verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/robot/attitude.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

constexpr std::size_t kDraws = 400;

/// Returns an estimate whose side has a step of 0.3 m ahead in every draw k with step(k).
template <class Left, class Right>
TwoTrackEstimate estimateWith(Left left, Right right)
{
    TwoTrackEstimate estimate;
    for (std::size_t side = 0; side < 2; ++side) {
        TerrainEstimate& own = estimate.side[side];
        own.settings.hazardRate = 0.0;
        own.ess.fill(static_cast<double>(kDraws));
        own.touch.fill(Touch::Felt);
        own.feltTo = binEnd(kBins - 1);
        for (std::size_t k = 0; k < kDraws; ++k) {
            Heights heights{};
            if (side == 0 ? left(k) : right(k)) heights[9] = heights[10] = 0.3;
            own.draws.push_back(heights);
        }
    }
    return estimate;
}

constexpr auto kNever = [](std::size_t) { return false; };
constexpr auto kAlways = [](std::size_t) { return true; };
constexpr auto kEvenDraws = [](std::size_t k) { return k % 2 == 0; };
constexpr auto kOddDraws = [](std::size_t k) { return k % 2 == 1; };

TwoTrackVerdict verdictFor(const TwoTrackEstimate& estimate)
{
    return verdictOf(estimate, absolem(), TwoTrackReadings{}, 0.1);
}

TEST(TwoTrackVerdict, eitherStepCountsJointDraws)
{
    EXPECT_DOUBLE_EQ(eitherStep(estimateWith(kEvenDraws, kEvenDraws), 0.1).p, 0.5);
    EXPECT_DOUBLE_EQ(eitherStep(estimateWith(kEvenDraws, kOddDraws), 0.1).p, 1.0);
    EXPECT_DOUBLE_EQ(eitherStep(estimateWith(kEvenDraws, kNever), 0.1).p, 0.5);
    EXPECT_DOUBLE_EQ(eitherStep(estimateWith(kEvenDraws, kNever), 0.1, kFirstAhead, {8, 8}).p, 0.0);
    TwoTrackEstimate unfelt = estimateWith(kNever, kNever);
    for (TerrainEstimate& side : unfelt.side) {
        side.settings.hazardRate = 0.05;
        side.touch[10] = Touch::NotFelt;
    }
    EXPECT_NEAR(eitherStep(unfelt, 0.1).p, 1.0 - 0.95 * 0.95, 1e-12);
    unfelt.side[1].draws.pop_back();
    EXPECT_THROW((void)eitherStep(unfelt, 0.1), std::invalid_argument);
}

TEST(TwoTrackVerdict, namesTheSideThatIsBlocked)
{
    const TwoTrackVerdict verdict = verdictFor(estimateWith(kAlways, kNever));
    EXPECT_EQ(verdict.side[0].stepVerdict, StepVerdict::Blocked);
    EXPECT_EQ(verdict.side[1].stepVerdict, StepVerdict::Clear);
    EXPECT_EQ(verdict.both, StepVerdict::Blocked);
    EXPECT_EQ(describe(verdict).find("left BLOCKED at +0.6 m · right CLEAR to +0.75 m"), 0U)
        << describe(verdict);
    EXPECT_EQ(describe(verdictFor(estimateWith(kNever, kNever))), "both CLEAR to +0.75 m");
    EXPECT_DOUBLE_EQ(answeredBy(verdict).p, 1.0);
}

TEST(TwoTrackVerdict, isClearOnlyIfBothSidesAreJointly)
{
    EXPECT_EQ(verdictFor(estimateWith(kNever, kNever)).both, StepVerdict::Clear);
    const auto rare = [](std::size_t k) { return k % 40 == 0; };
    const auto otherRare = [](std::size_t k) { return k % 40 == 1; };
    const TwoTrackVerdict apart = verdictFor(estimateWith(rare, otherRare));
    EXPECT_EQ(apart.side[0].stepVerdict, StepVerdict::Clear);
    EXPECT_EQ(apart.side[1].stepVerdict, StepVerdict::Clear);
    EXPECT_EQ(apart.both, StepVerdict::CannotTell);
    EXPECT_EQ(describe(apart), "CANNOT TELL for the robot · each side CLEAR to +0.75 m");
    EXPECT_EQ(verdictFor(estimateWith(rare, rare)).both, StepVerdict::Clear);
    const TwoTrackVerdict surely = verdictFor(estimateWith(kEvenDraws, kOddDraws));
    EXPECT_EQ(surely.both, StepVerdict::Blocked);
    EXPECT_EQ(describe(surely), "BLOCKED for the robot · each side CANNOT TELL");
    TwoTrackEstimate novel = estimateWith(kNever, kNever);
    novel.side[0].novelty = novel.side[1].novelty = 1.5;
    EXPECT_EQ(verdictFor(novel).both, StepVerdict::CannotTell);
}

TEST(TwoTrackVerdict, unfeltGroundBehindTheHorizonDoesNotWithhold)
{
    TwoTrackEstimate estimate = estimateWith(kNever, kNever);
    for (TerrainEstimate& side : estimate.side) {
        side.feltTo = binEnd(8);
        side.touch[9] = side.touch[10] = Touch::NotFelt;
        side.ceiling[9] = side.ceiling[10] = std::numeric_limits<double>::infinity();
    }
    for (std::size_t k = 0; k < kDraws / 10; ++k) estimate.side[0].draws[k][10] = -2.0;  // a drop
    const TwoTrackVerdict verdict = verdictFor(estimate);
    EXPECT_GT(verdict.crossSlope.beyond.p, kClearBelow);
    EXPECT_EQ(verdict.both, StepVerdict::Clear);
    EXPECT_EQ(describe(verdict), "both CLEAR to +0.55 m");
    EXPECT_DOUBLE_EQ(verdict.either.p, 0.1) << "the drop beyond the horizon";
    EXPECT_DOUBLE_EQ(answeredBy(verdict).p, 0.0);
    EXPECT_DOUBLE_EQ(answeredBy(verdict.side[0]).p, 0.0);
}

TEST(TwoTrackVerdict, rollIsNoReasonToWithhold)
{
    TwoTrackReadings s;
    s.roll = 0.3;
    s.flippers = {0.4, 0.0, 0.0, 0.0};
    EXPECT_EQ(verdictOf(estimateWith(kNever, kNever), absolem(), s, 0.1).both, StepVerdict::Clear);
}

TEST(TwoTrackVerdict, aCrossSlopeThatTipsTheRobotBlocks)
{
    TwoTrackEstimate estimate = estimateWith(kNever, kNever);
    for (Heights& draw : estimate.side[0].draws)
        for (std::size_t i = 6; i < kBins; ++i) draw[i] = 0.8;
    const TwoTrackVerdict verdict = verdictFor(estimate);
    const double tips = tipOver(absolem(), 0.0, 0.0).leftUp;
    EXPECT_NEAR(verdict.crossSlope.limit, tips - kRedReserve, 1e-12);
    EXPECT_NEAR(verdict.crossSlope.steepest, std::atan(0.8 / 0.544), 1e-9);
    EXPECT_DOUBLE_EQ(verdict.crossSlope.beyond.p, 1.0);
    EXPECT_EQ(verdict.both, StepVerdict::Blocked);
    EXPECT_NE(describe(verdict).find("cross slope 56° of "), std::string::npos)
        << describe(verdict);
}

TEST(TwoTrackVerdict, aSlopeToTheHeavySideBlocksEarlier)
{
    RobotModel robot = absolem();
    robot.lateral.bodyComY = 0.15;
    TwoTrackReadings s;
    for (const std::size_t higher : {0U, 1U}) {
        TwoTrackEstimate estimate = estimateWith(kNever, kNever);
        for (Heights& draw : estimate.side.at(higher).draws)
            for (std::size_t i = 6; i < kBins; ++i) draw[i] = 0.3;
        const TwoTrackVerdict verdict = verdictOf(estimate, robot, s, 0.4);
        const bool isBlocked = higher == 1U;  // a slope of 29°: the robot's left side is heavy
        EXPECT_EQ(verdict.both, isBlocked ? StepVerdict::Blocked : StepVerdict::Clear);
        EXPECT_DOUBLE_EQ(verdict.crossSlope.beyond.p, isBlocked ? 1.0 : 0.0);
        const TipOver tips = tipOver(robot, 0.0, 0.0);
        EXPECT_NEAR(verdict.crossSlope.limit,
                    (isBlocked ? tips.rightUp : tips.leftUp) - kRedReserve, 1e-12);
    }
}

TEST(TwoTrackVerdict, ofOnePlaneReadsAsThatOfOnePlane)
{
    const TwoTrackEstimate plane = equalSides(estimateWith(kEvenDraws, kNever).side[0]);
    for (const double roll : {0.0, 0.2}) {
        Measurement line;
        line.roll = roll;
        const LinkSinceScene late{.telemetryFresh = false};
        for (const LinkSinceScene& since : {LinkSinceScene{}, late}) {
            const Verdict own = verdictOf(plane.side[0], line, since, 0.1);
            const TwoTrackVerdict both = verdictOf(plane, absolem(), line, since, 0.1);
            EXPECT_TRUE(both.onePlane);
            EXPECT_EQ(both.side[0], own);
            EXPECT_EQ(both.side[1], own);
            EXPECT_EQ(both.both, own.stepVerdict);
            EXPECT_EQ(both.either, own.step);
            EXPECT_EQ(describe(both), stepVerdictMessage(own).english());
        }
    }
}

TEST(TwoTrackVerdict, ofALineIsThatOfItsReadings)
{
    const TwoTrackEstimate estimate = estimateWith(kAlways, kNever);
    Measurement line;
    line.roll = 0.2;
    EXPECT_EQ(verdictOf(estimate, absolem(), line, {}, 0.1),
              verdictOf(estimate, absolem(), twoTrackReadings(line), 0.1));
    TwoTrackEstimate bare = estimate;
    for (TerrainEstimate& side : bare.side) side.draws.clear();
    EXPECT_EQ(verdictOf(bare, absolem(), line, {}, 0.1).side[0].stepVerdict,
              StepVerdict::CannotTell);
    EXPECT_EQ(verdictOf(bare, absolem(), line, {}, 0.1).both, StepVerdict::CannotTell);
    EXPECT_EQ(verdictOf(bare, absolem(), line, {}, 0.1).either, (StepProbability{0.0, 1.0}));
}

TEST(TwoTrackVerdict, cannotTellOfASideOrOfTheRobotIsFound)
{
    TwoTrackVerdict verdict = verdictFor(estimateWith(kNever, kNever));
    ASSERT_EQ(verdict.both, StepVerdict::Clear);
    EXPECT_FALSE(hasCannotTell(verdict));
    verdict.both = StepVerdict::CannotTell;
    EXPECT_TRUE(hasCannotTell(verdict)) << "each side is clear";
    verdict.both = StepVerdict::Blocked;
    verdict.side[1].stepVerdict = StepVerdict::CannotTell;
    EXPECT_TRUE(hasCannotTell(verdict)) << "the left side blocks";
}

}  // namespace
}  // namespace terratact
