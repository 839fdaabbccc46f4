#include "core/strip/strip_ledger.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "core/strip/scene_scores.h"
#include "core/strip/strip.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"

namespace terratact {
namespace {

HeightBand normal(double height, double sd)
{
    return {height, sd, height - 1.2815515655 * sd, height + 1.2815515655 * sd};
}

TEST(StripLedger, calibratedBandsHoldEightTenthsOfNoisyTouches)
{
    std::mt19937_64 rng(3);
    std::normal_distribution<double> error(0.0, 0.02), noise(0.0, 0.015);
    StripLedger ledger;
    for (int k = 0; k < 4000; ++k) {
        const double truth = 0.01 * k;
        ledger.add(ScoredBy::Contact, normal(truth + error(rng), 0.02), truth + noise(rng), 0.015);
    }
    const StripScore& score = ledger.of(ScoredBy::Contact);
    EXPECT_EQ(score.n, 4000U);
    EXPECT_NEAR(static_cast<double>(score.in80) / 4000.0, 0.80, 0.02);
    EXPECT_NEAR(score.meanZ(), 0.0, 0.05);
    EXPECT_NEAR(score.rmsZ(), 1.0, 0.05);
    EXPECT_EQ(ledger.of(ScoredBy::Pass), StripScore{});
    EXPECT_EQ(ledger.all(), score);
}

TEST(StripLedger, theTouchesOwnErrorWidensTheBand)
{
    StripLedger sharp, blunt;
    sharp.add(ScoredBy::Probe, normal(0.0, 0.01), 0.03, 0.0);
    blunt.add(ScoredBy::Probe, normal(0.0, 0.01), 0.03, 0.03);
    EXPECT_EQ(sharp.all().in80, 0U);
    EXPECT_EQ(blunt.all().in80, 1U);
    EXPECT_NEAR(sharp.all().meanZ(), 3.0, 1e-9);
}

TEST(StripLedger, sumsByTouch)
{
    StripLedger ledger, other;
    ledger.add(ScoredBy::Contact, normal(0.0, 0.01), 0.0, 0.0);
    other.add(ScoredBy::Pass, normal(0.0, 0.01), 1.0, 0.0);
    ledger += other;
    EXPECT_EQ(ledger.of(ScoredBy::Contact).in80, 1U);
    EXPECT_EQ(ledger.of(ScoredBy::Pass).n, 1U);
    EXPECT_EQ(ledger.all().n, 2U);
    EXPECT_EQ(ledger.all().in80, 1U);
}

TEST(StripLedger, refusesWhatIsNoMeasurement)
{
    StripLedger ledger;
    EXPECT_THROW(ledger.add(ScoredBy::Pass, normal(0.0, 0.01), std::nan(""), 0.01),
                 std::invalid_argument);
    EXPECT_THROW(ledger.add(ScoredBy::Pass, normal(0.0, 0.01), 0.0, -0.01), std::invalid_argument);
    EXPECT_THROW(ledger.add(ScoredBy::Pass, normal(0.0, 0.0), 0.0, 0.0), std::invalid_argument);
    EXPECT_EQ(ledger, StripLedger{});
}

/// Explores even ground with a robot that may lie about its way.
struct StripLedgerDrive : testing::Test {
    Strip strip{absolem()};
    Measurement line;

    StripLedgerDrive()
    {
        line.travelled = 0.0;
        line.turned = 0.0;
        strip.add(line);
    }
    /// Returns an estimate of even ground, on which the tracks stand.
    static TwoTrackEstimate even(double height)
    {
        TerrainEstimate e = stepEstimate();
        e.height.fill(height);
        e.sd.fill(0.01);
        e.q10.fill(height - 0.0128);
        e.q90.fill(height + 0.0128);
        for (std::size_t i = 0; i < kBins; ++i)
            e.touch[i] = i < kFirstAhead ? Touch::Felt : Touch::Bounded;
        return equalSides(e);
    }
    void drive(double way)
    {
        line.time += 0.5;
        *line.travelled += way;
        strip.add(line);
    }
    void explore(const TwoTrackEstimate& estimate, std::span<const ArmReading> arm = {})
    {
        strip.beginScene(line);
        strip.enter(estimate, ++id, arm);
    }
    StripScore score(ScoredBy by) const { return strip.ledger().of(by); }

    std::int64_t id = 0;
};

TEST_F(StripLedgerDrive, theTracksScoreWhatWasSaidOfTheGroundAhead)
{
    explore(even(-0.25));
    EXPECT_EQ(strip.ledger().all().n, 0U) << "nothing was said before";
    drive(0.3);
    explore(even(-0.25));
    const StripScore passes = score(ScoredBy::Pass);
    EXPECT_GE(passes.n, 5U);
    EXPECT_EQ(passes.in80, passes.n);
    drive(0.3);
    explore(even(-0.40));
    EXPECT_EQ(score(ScoredBy::Pass).in80, passes.n) << "0.15 m lower than was said";
    EXPECT_GT(score(ScoredBy::Pass).n, passes.n);
}

TEST_F(StripLedgerDrive, theSceneThatTouchesDoesNotCorrectWhatWasSaid)
{
    explore(even(-0.25));
    line.pitch = 0.3;  // says the IMU of a robot that climbs 0.09 m
    drive(0.3);
    line.pitch = 0.0;
    drive(0.001);
    explore(even(-0.25));
    const StripScore passes = score(ScoredBy::Pass);
    ASSERT_GT(passes.n, 0U);
    EXPECT_GT(passes.meanZ(), 0.5) << "the strip's correction by the shared ground would hide it";
}

TEST_F(StripLedgerDrive, aSceneCountsOnceByItsFirstEstimate)
{
    explore(even(-0.25));
    drive(0.3);
    explore(even(-0.25));
    const StripLedger first = strip.ledger();
    strip.enter(even(-0.60), 9);
    EXPECT_EQ(strip.ledger(), first);
}

TEST_F(StripLedgerDrive, anEstimateTakenOutTakesItsTouchesOut)
{
    explore(even(-0.25));
    drive(0.3);
    explore(even(-0.25));
    const StripLedger scored = strip.ledger();
    strip.removeLast();
    EXPECT_EQ(strip.ledger().all().n, 0U);
    strip.enter(even(-0.25), 9);
    EXPECT_EQ(strip.ledger(), scored);
    drive(0.3);
    strip.beginScene(line);
    strip.removeLast();
    EXPECT_EQ(strip.ledger(), scored) << "of earlier scenes they are final";
}

TEST_F(StripLedgerDrive, aReadingOfTheArmScoresTheBandShownBefore)
{
    const std::vector<ArmReading> inside{{.bin = 9, .height = -0.245, .sd = 0.01}};
    explore(even(-0.25));
    TwoTrackEstimate probed = even(-0.25);
    probed.side[0].origin[9] = probed.side[1].origin[9] = Origin::Arm;
    strip.enter(probed, 2, inside);
    EXPECT_EQ(score(ScoredBy::Probe).n, 1U);
    EXPECT_EQ(score(ScoredBy::Probe).in80, 1U);
    strip.enter(probed, 3, inside);
    EXPECT_EQ(score(ScoredBy::Probe).n, 1U) << "the same reading";
    const std::vector<ArmReading> again{inside[0], {.bin = 9, .height = -0.5, .sd = 0.01}};
    strip.enter(probed, 4, again);
    EXPECT_EQ(score(ScoredBy::Probe).n, 1U) << "the arm had measured it";
    const std::vector<ArmReading> other{{.bin = 10, .height = -0.5, .sd = 0.01}};
    strip.enter(probed, 5, other);
    EXPECT_EQ(score(ScoredBy::Probe).n, 2U);
    EXPECT_EQ(score(ScoredBy::Probe).in80, 1U);
    strip.removeLast();
    EXPECT_EQ(score(ScoredBy::Probe).n, 2U) << "the probe was made";
}

TEST_F(StripLedgerDrive, numbersWithoutAnErrorScoreNothing)
{
    TwoTrackEstimate exact = even(-0.25);
    for (TerrainEstimate& side : exact.side) {
        side.sd.fill(0.0);
        side.q10 = side.q90 = side.height;
    }
    explore(exact);
    strip.enter(exact, 2, std::vector<ArmReading>{{.bin = 9, .height = -0.25, .sd = 0.0}});
    EXPECT_EQ(strip.ledger().all().n, 0U);
    strip.enter(exact, 3, std::vector<ArmReading>{{.bin = 9, .height = 1e308, .sd = 1e200}});
    EXPECT_EQ(strip.ledger().all().n, 1U);
    explore(exact);
    EXPECT_NO_THROW(explore(even(1e308)));
}

TEST_F(StripLedgerDrive, aReadingBetweenTwoSidesIsOfNeither)
{
    TwoTrackEstimate sides = even(-0.25);
    sides.onePlane = false;
    explore(sides);
    const std::vector<ArmReading> arm{
        {.bin = 9, .height = -0.25, .sd = 0.01},
        {.bin = 9, .height = -0.25, .sd = 0.01, .side = ProbeSide::Right}};
    strip.enter(sides, 2, arm);
    EXPECT_EQ(score(ScoredBy::Probe).n, 1U);
}

TEST_F(StripLedgerDrive, aBreakOfTheWayScoresNothing)
{
    explore(even(-0.25));
    strip.endSection();
    drive(0.1);
    explore(even(-0.25));
    EXPECT_EQ(strip.ledger().all().n, 0U);
}

TEST_F(StripLedgerDrive, aContactIsThatOfTheReadingsNotOfTheEstimate)
{
    line.frontLeft = line.frontRight = -0.3;  // the tips lie low
    line.force = {0.0, 0.0, 0.0, 0.0, 0.0, 20.0};
    explore(even(-0.25));
    drive(0.1);
    strip.beginScene(line);
    const auto touches = strip.touchesOf(even(0.7));
    const auto contact = std::ranges::find(touches, ScoredBy::Contact, &StripTouch::by);
    ASSERT_NE(contact, touches.end());
    EXPECT_LT(contact->felt, 0.0) << "below the IMU, whatever the estimate says";
    EXPECT_NEAR(contact->feltSd, 0.02, 1e-12);
    EXPECT_NEAR(contact->predicted.height, -0.25, 0.01);
}

TEST_F(StripLedgerDrive, theTracksDoNotScoreTheFlippersLine)
{
    TwoTrackEstimate sides = even(-0.25);
    sides.onePlane = false;
    explore(sides);
    drive(0.8);
    explore(sides);
    EXPECT_EQ(score(ScoredBy::Pass).n, 0U) << "another line was said ahead";
    drive(0.1);
    explore(sides);
    EXPECT_GT(score(ScoredBy::Pass).n, 0U);
}

}  // namespace
}  // namespace terratact
