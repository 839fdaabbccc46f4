#include "core/strip/strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "tests/support/absolem.h"
#include "tests/support/estimates.h"

namespace terratact {
namespace {

/// Returns an estimate of even ground at `height` that was felt everywhere.
TerrainEstimate even(double height, double sd = 0.01)
{
    TerrainEstimate e;
    e.height.fill(height);
    e.mean.fill(height);
    e.sd.fill(sd);
    e.q10.fill(height - 1.28 * sd);
    e.q90.fill(height + 1.28 * sd);
    e.ceiling.fill(0.0);
    e.touch.fill(Touch::Felt);
    return e;
}

/// Drives a robot over level ground and enters estimates.
struct StripTest : testing::Test {
    Strip strip{absolem()};
    Measurement line;

    StripTest()
    {
        line.travelled = 5.0;
        line.turned = 3.1;
        strip.add(line);
    }

    void drive(double way, double step = 0.05)
    {
        const auto steps = static_cast<int>(std::lround(std::abs(way) / step));
        for (int k = 0; k < steps; ++k) {
            line.time += 0.1;
            *line.travelled += std::copysign(step, way);
            strip.add(line);
        }
    }
    void turn(double angle)
    {
        line.time += 0.1;
        line.turned = std::remainder(*line.turned + angle, 2.0 * std::numbers::pi);
        strip.add(line);
    }
    void explore(const TwoTrackEstimate& estimate)
    {
        strip.beginScene(line);
        strip.enter(estimate, ++estimates);
    }
    void explore(const TerrainEstimate& estimate) { explore(equalSides(estimate)); }

    std::optional<SeenBin> at(double x, std::size_t side = 0) const
    {
        const SeenStrip seen = strip.seen();
        for (const SeenBin& bin : seen.side.at(side))
            if (std::abs(bin.x - x) < 1e-6) return bin;
        return std::nullopt;
    }

    std::int64_t estimates = 0;
};

TEST_F(StripTest, isTheEstimateItselfWhereItWasFelt)
{
    const TerrainEstimate e = probedEstimate();
    explore(e);
    const SeenStrip seen = strip.seen();
    ASSERT_EQ(seen.side[0].size(), std::size_t{kBins});
    EXPECT_EQ(seen.side[0], seen.side[1]);
    EXPECT_TRUE(seen.onePlane);
    for (std::size_t i = 0; i < kBins; ++i) {
        const SeenBin& bin = seen.side[0][i];
        EXPECT_NEAR(bin.x, binCentre(static_cast<int>(i)), 1e-9);
        EXPECT_NEAR(bin.band.height, e.height[i], 1e-9);
        EXPECT_NEAR(bin.band.sd, e.sd[i], 1e-4);
        EXPECT_NEAR(bin.band.q90, e.q90[i], 1e-3);
        EXPECT_EQ(bin.way, 0.0);
    }
    EXPECT_EQ(seen.side[0][9].felt, FeltBy::Arm);
}

TEST_F(StripTest, staysBehindAsTheRobotDrivesOn)
{
    explore(stepEstimate());
    drive(0.8);
    const auto step = at(-0.1), edge = at(-0.4);
    ASSERT_TRUE(step && edge);
    EXPECT_NEAR(step->band.height, -0.05, 1e-9) << "0.7 m ahead before";
    EXPECT_NEAR(edge->band.height, -0.25, 1e-9);
    EXPECT_NEAR(step->way, 0.8, 1e-9);
    EXPECT_GT(edge->band.sd, 0.01) << "less certain with the way";
    const double before = at(-0.4)->band.sd;
    drive(1.0);
    EXPECT_GT(at(-1.4)->band.sd, before);
}

TEST_F(StripTest, growsOverTheWholeDrive)
{
    for (int k = 0; k < 40; ++k) {
        explore(even(-0.25));
        drive(0.3);
    }
    EXPECT_EQ(strip.sections().size(), 1U);
    EXPECT_EQ(strip.seen().side[0].size(), std::size_t{kBins} + 39 * 3);
    EXPECT_LT(strip.seen().side[0].front().x, -11.9);
}

TEST_F(StripTest, sharedGroundCorrectsTheHeightOfTheWay)
{
    Strip uncorrected(absolem(), {.corrects = false});
    uncorrected.add(line);
    for (const bool second : {false, true}) {
        explore(even(-0.25));
        uncorrected.beginScene(line);
        uncorrected.enter(equalSides(even(-0.25)), 1);
        if (second) break;
        line.pitch = 0.1;  // says the IMU, but the ground is felt at the same height
        line.time += 0.1;
        strip.add(line);
        uncorrected.add(line);
        line.time += 0.5;
        *line.travelled += 0.3;
        strip.add(line);
        uncorrected.add(line);
        line.pitch = 0.0;
        strip.add(line);
        uncorrected.add(line);
    }
    const SeenStrip seen = strip.seen(), drifted = uncorrected.seen();
    EXPECT_NEAR(drifted.side[0].front().band.height, -0.28, 0.002) << "0.3 m at 0.1 rad";
    EXPECT_NEAR(seen.side[0].front().band.height, -0.25, 0.010);
    EXPECT_LT(seen.side[0].front().band.sd, drifted.side[0].front().band.sd);
}

TEST_F(StripTest, theNewerEstimateStands)
{
    explore(even(-0.25, 0.005));
    explore(even(-0.24, 0.010));
    EXPECT_NEAR(at(0.0)->band.height, -0.24, 2e-3);
    EXPECT_NEAR(at(0.0)->band.sd, 0.010, 1e-4);
}

TEST_F(StripTest, feltGroundIsNotLostToABoundAbove)
{
    explore(even(-0.25, 0.005));
    TerrainEstimate bounded = even(-0.26, 0.02);
    bounded.touch.fill(Touch::Bounded);
    explore(bounded);
    EXPECT_EQ(at(0.0)->felt, FeltBy::Track);
    EXPECT_EQ(at(0.5)->felt, FeltBy::Contact);
    EXPECT_NEAR(at(0.0)->band.sd, 0.005, 1e-4);
    TerrainEstimate far = even(-0.60, 0.01);
    far.touch.fill(Touch::Bounded);
    explore(far);
    EXPECT_EQ(at(0.0)->felt, FeltBy::Bounded)
        << "the two contradict each other: the newer one stands";
}

TEST_F(StripTest, whatIsNotFeltDoesNotReplaceWhatIsKnown)
{
    TerrainEstimate ahead = even(-0.25, 0.01);
    ahead.touch.fill(Touch::Bounded);
    explore(ahead);
    drive(-0.4);
    TerrainEstimate unfelt = even(-0.25, 0.08);
    unfelt.touch.fill(Touch::NotFelt);
    explore(unfelt);
    EXPECT_EQ(at(0.5)->felt, FeltBy::Bounded);
    EXPECT_EQ(at(-0.2)->felt, FeltBy::NotFelt) << "nothing else is known there";
}

TEST_F(StripTest, anEstimateWithTheArmReplacesThatOfTheSameScene)
{
    strip.beginScene(line);
    strip.enter(equalSides(stepEstimate()), 1);
    strip.enter(equalSides(probedEstimate()), 2);
    EXPECT_EQ(at(0.6)->felt, FeltBy::Arm);
    strip.removeLast();
    EXPECT_TRUE(strip.sections().empty());
    EXPECT_EQ(strip.whyNothing(), SectionStart::First);
    strip.enter(equalSides(stepEstimate()), 3);
    EXPECT_NEAR(at(0.6)->band.sd, 0.09, 1e-4);
}

TEST_F(StripTest, takingAnEstimateOutBringsBackTheOneBefore)
{
    explore(even(-0.25, 0.01));
    drive(0.3);
    const SeenStrip before = strip.seen();
    explore(even(-0.20, 0.01));
    ASSERT_NE(strip.seen(), before);
    strip.removeLast();
    EXPECT_EQ(strip.seen(), before);
}

TEST_F(StripTest, sidesAreKeptApart)
{
    explore(leftStepEstimate());
    EXPECT_FALSE(strip.seen().onePlane);
    EXPECT_NEAR(at(0.6, 0)->band.height, -0.05, 1e-9);
    EXPECT_NEAR(at(0.6, 1)->band.height, -0.25, 1e-9);
    EXPECT_EQ(at(0.7, 1)->felt, FeltBy::NotFelt);
}

TEST_F(StripTest, aTightTurnBeginsASection)
{
    explore(even(-0.25));
    turn(0.11);
    EXPECT_TRUE(strip.seen().isEmpty());
    EXPECT_EQ(strip.whyNothing(), SectionStart::Turned);
    explore(even(-0.25));
    ASSERT_EQ(strip.sections().size(), 2U);
    EXPECT_EQ(strip.sections()[0].why, SectionStart::First);
    EXPECT_EQ(strip.sections()[1].why, SectionStart::Turned);
    EXPECT_EQ(strip.whyNothing(), std::nullopt);
}

TEST_F(StripTest, groundBeforeATurnIsEarlierGround)
{
    explore(leftStepEstimate());
    EXPECT_TRUE(strip.earlier().empty()) << "the present section is none";
    turn(0.11);
    const std::vector<EarlierSection> before = strip.earlier();
    ASSERT_EQ(before.size(), 1U) << "though no section follows yet";
    EXPECT_EQ(before[0].next, SectionStart::Turned);
    EXPECT_FALSE(before[0].onePlane);
    explore(even(-0.3));
    EXPECT_EQ(strip.earlier(), before);
    EXPECT_EQ(strip.seen().side[0].size(), std::size_t{kBins}) << "seen() is the present section";
    EXPECT_TRUE(strip.seen().onePlane);
    const TwoTrackEstimate held = leftStepEstimate();
    for (std::size_t side = 0; side < 2; ++side) {
        ASSERT_EQ(before[0].side.at(side).size(), std::size_t{kBins});
        for (std::size_t i = 0; i < kBins; ++i) {
            const EarlierBin& bin = before[0].side.at(side)[i];
            EXPECT_NEAR(bin.x, binCentre(static_cast<int>(i)), 1e-9);
            EXPECT_NEAR(bin.height, held.side.at(side).height[i], 1e-9);
        }
    }
}

TEST_F(StripTest, earlierSectionsAreBoundedNewestFirst)
{
    for (int k = 0; k < 12; ++k) {
        explore(even(-0.01 * k));
        turn(0.11);
    }
    const std::vector<EarlierSection> earlier = strip.earlier();
    ASSERT_EQ(earlier.size(), Strip::kEarlier);
    EXPECT_NEAR(earlier.front().side[0][0].height, -0.11, 1e-9);
    EXPECT_NEAR(earlier.back().side[0][0].height, -0.04, 1e-9);
}

TEST_F(StripTest, clearedGroundIsNotEarlierGround)
{
    explore(even(-0.25));
    turn(0.11);
    explore(even(-0.25));
    strip.endSection();
    EXPECT_TRUE(strip.earlier().empty());
    strip.addSilence();
    drive(0.1);
    EXPECT_TRUE(strip.earlier().empty()) << "nor after another break";
    explore(even(-0.25));
    turn(0.11);
    EXPECT_EQ(strip.earlier().size(), 1U);
}

TEST_F(StripTest, aWideCurveDoesNotEndASection)
{
    explore(even(-0.25));
    for (int k = 0; k < 20; ++k) {  // 1 rad within 4 m
        turn(0.05);
        drive(0.2);
    }
    EXPECT_EQ(strip.whyNothing(), std::nullopt);
}

TEST_F(StripTest, everyBreakHasItsReason)
{
    explore(even(-0.25));
    line.time += 1.1;
    strip.add(line);
    EXPECT_EQ(strip.whyNothing(), SectionStart::TelemetryGap);
    explore(even(-0.25));
    *line.travelled -= 4.0;
    strip.add(line);
    EXPECT_EQ(strip.whyNothing(), SectionStart::OdometryJump);
    explore(even(-0.25));
    strip.endSection();
    EXPECT_EQ(strip.whyNothing(), SectionStart::Cleared);
    strip.add(line);
    explore(even(-0.25));
    strip.addSilence();
    EXPECT_EQ(strip.whyNothing(), SectionStart::TelemetryGap);
    strip.add(line);
    explore(even(-0.25));
    line.travelled.reset();
    strip.add(line);
    EXPECT_EQ(strip.whyNothing(), SectionStart::NoOdometry);
    const std::size_t sections = strip.sections().size();
    explore(even(-0.25));
    EXPECT_EQ(strip.sections().size(), sections) << "without odometry an estimate has no place";
    std::set<std::string> words;
    std::set<std::string_view> names;
    for (const SectionStart why : kSectionStarts) {
        EXPECT_TRUE(words.insert(describe(why).english).second);
        EXPECT_TRUE(names.insert(name(why)).second);
    }
}

TEST_F(StripTest, aSuspectedPitchTakesNothing)
{
    strip.add(line, {{.sensor = Sensor::Pitch}});
    EXPECT_EQ(strip.whyNothing(), SectionStart::Suspected);
    strip.add(line);
    explore(even(-0.25));
    strip.add(line, {{.sensor = Sensor::Force1}});
    EXPECT_EQ(strip.whyNothing(), std::nullopt) << "a force places nothing";
    for (const Sensor sensor : {Sensor::Pitch, Sensor::Travelled}) {
        const std::size_t sections = strip.sections().size();
        strip.add(line, {{.sensor = sensor}});
        EXPECT_EQ(strip.whyNothing(), SectionStart::Suspected);
        explore(even(-0.30));
        EXPECT_EQ(strip.sections().size(), sections) << "the estimate has no place";
        EXPECT_TRUE(strip.seen().isEmpty());
        strip.add(line);
        explore(even(-0.25));
        ASSERT_EQ(strip.sections().size(), sections + 1);
        EXPECT_EQ(strip.sections().back().why, SectionStart::Suspected);
    }
}

TEST_F(StripTest, aSuspectedPitchHidesNoMissingOdometry)
{
    strip.add(line, {{.sensor = Sensor::Pitch}});
    line.travelled.reset();
    strip.add(line);
    EXPECT_EQ(strip.whyNothing(), SectionStart::NoOdometry);
}

TEST_F(StripTest, aRestartedOdometryBreaksTheWay)
{
    drive(-4.7);
    explore(even(-0.25));
    line.time += 0.05;
    line.travelled = 0.0;
    strip.add(line);
    EXPECT_EQ(strip.whyNothing(), SectionStart::OdometryJump) << "0.3 m in 50 ms";
}

TEST_F(StripTest, aDriveThroughLostTelemetryIsNoJump)
{
    explore(even(-0.25));
    line.time += 0.9;
    *line.travelled += 0.54;
    strip.add(line);
    EXPECT_EQ(strip.whyNothing(), std::nullopt) << "0.6 m/s";
    line.time += 0.05;
    *line.travelled += 0.17;
    strip.add(line);
    EXPECT_EQ(strip.whyNothing(), std::nullopt) << "it tips over an edge";
}

TEST_F(StripTest, anEstimateThatComesAfterABreakBelongsBefore)
{
    explore(even(-0.25));
    drive(0.3);
    strip.beginScene(line);
    turn(0.2);
    strip.enter(equalSides(even(-0.25)), 2);
    ASSERT_EQ(strip.sections().size(), 1U);
    EXPECT_EQ(strip.sections()[0].columns.size(), std::size_t{kBins} + 3);
    EXPECT_EQ(strip.whyNothing(), SectionStart::Turned);
}

TEST_F(StripTest, memoryIsBoundedAndTheOldestGoesFirst)
{
    Strip small(absolem(), {.columns = 50, .sources = 20});
    for (int k = 0; k < 300; ++k) {
        small.add(line);
        small.beginScene(line);
        small.enter(equalSides(even(-0.25)), k);
        *line.travelled += 0.3;
        line.time += 0.5;
    }
    std::size_t columns = 0;
    for (const StripSection& section : small.sections()) columns += section.columns.size();
    EXPECT_EQ(columns, 50U);
    const auto& [index, column] = *small.sections().back().columns.rbegin();
    EXPECT_EQ(small.source(*column[0]).estimate, 299);
}

TEST(FeltBy, namesDiffer)
{
    std::set<std::string_view> names;
    for (const FeltBy felt : kFeltBy) EXPECT_TRUE(names.insert(name(felt)).second);
    EXPECT_EQ(across(FeltBy::Track, FeltBy::Contact), FeltBy::Track);
    EXPECT_EQ(across(FeltBy::Track, FeltBy::Bounded), FeltBy::InPart);
    EXPECT_EQ(across(FeltBy::Bounded, FeltBy::NotFelt), FeltBy::NotFelt);
}

TEST(HeightBand, fusionStatesItsCertainty)
{
    const HeightBand a{-0.20, 0.01, -0.2128, -0.1872}, b{-0.24, 0.02, -0.2656, -0.2144};
    EXPECT_EQ(fused(a, b, Fusion::MoreCertain), a);
    EXPECT_EQ(fused(a, b, Fusion::Newest), b);
    const HeightBand independent = fused(a, b, Fusion::Independent);
    EXPECT_NEAR(independent.height, -0.208, 1e-9);
    EXPECT_NEAR(independent.sd, 0.01 * 0.02 / std::hypot(0.01, 0.02), 1e-9);
    const HeightBand intersection = fused(a, b, Fusion::Intersection);
    EXPECT_NEAR(intersection.sd, std::sqrt(2.0) * independent.sd, 1e-9)
        << "agreement is no evidence";
}

}  // namespace
}  // namespace terratact
