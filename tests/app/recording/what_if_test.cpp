// Tests recomputed estimates of a session and their differences from the recorded ones.
#include "app/recording/what_if.h"

#include <gtest/gtest.h>

#include <array>

#include "core/store/sha256.h"
#include "tests/support/estimates.h"
#include "tests/support/refusal.h"
#include "tests/support/sessions/recorded_drive.h"

namespace terratact {
namespace {

TEST_F(Drive, estimatesComeOutAgainBitForBit)
{
    ASSERT_GE(reader.estimates().size(), 3U);
    EXPECT_FALSE(reader.estimates().back().readings.empty()) << "no probe in this drive";
    for (const EstimateRow& row : reader.estimates()) {
        const auto before = recordedEstimate(reader, row);
        ASSERT_TRUE(before) << before.error().text;
        const auto again = estimateAgain(reader, row, *models, row.estimate.side[0].settings);
        ASSERT_TRUE(again) << again.error().text;
        const Measurement& scene = reader.scene(row.scene)->measurement;
        const Differences same =
            differencesBetween(*before, *again, *robotOf(reader), scene, row.stepLimit);
        EXPECT_EQ(same.match, Match::Identical) << row.id;
        EXPECT_EQ(same.largest(), 0.0);
        EXPECT_EQ(same.before, same.after);

        Settings other = row.estimate.side[0].settings;
        other.seed += 1;
        const auto moved = estimateAgain(reader, row, *models, other);
        ASSERT_TRUE(moved);
        EXPECT_EQ(differencesBetween(*before, *moved, *robotOf(reader), scene, row.stepLimit).match,
                  Match::Other);
    }
}

TEST_F(Drive, recomputedEstimatesUseTheArmReadings)
{
    EstimateRow row = reader.estimates().back();
    const auto with = estimateAgain(reader, row, *models, row.estimate.side[0].settings);
    const std::size_t bin = static_cast<std::size_t>(row.readings.at(0).bin);
    row.readings.clear();
    const auto without = estimateAgain(reader, row, *models, row.estimate.side[0].settings);
    ASSERT_TRUE(with && without);
    EXPECT_EQ(with->side[0].origin[bin], Origin::Arm);
    EXPECT_NE(without->side[0].origin[bin], Origin::Arm);
}

TEST_F(Drive, rowsThatCannotBeEstimatedAreErrorsWithTheFile)
{
    EstimateRow row = reader.estimates().front();
    Settings wrong = row.estimate.side[0].settings;
    wrong.contactSd = 0.0;
    wrong.draws = 0;
    EXPECT_TRUE(refused(estimateAgain(reader, row, *models, wrong), reader.path(), {"estimate 1"}));
    row.scene = 77;
    EXPECT_TRUE(refused(estimateAgain(reader, row, *models, row.estimate.side[0].settings),
                        reader.path(), {"scene is not there"}));
}

TEST_F(Drive, modelsAreFoundByTheirHash)
{
    const ModelRow& row = reader.models().front();
    const std::array both{std::string(kRobot), std::string(kModel)};
    EXPECT_EQ(*modelFileOf(row, both), kModel);
    const auto none = modelFileOf(row, std::span(both).first(1));
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text.find("default.ttm"), std::string::npos);
    EXPECT_NE(none.error().text.find(sha256OfFile(kRobot)->substr(0, 12)), std::string::npos);
}

TEST(Differences, distinguishesBitsThatCompareEqual)
{
    const TerrainEstimate zero = [] {
        TerrainEstimate e = stepEstimate();
        e.mean[3] = 0.0;
        return e;
    }();
    TerrainEstimate minus = zero;
    minus.mean[3] = -0.0;
    ASSERT_EQ(zero, minus);
    const auto match = [&](const TerrainEstimate& other) {
        return differencesBetween(equalSides(zero), equalSides(other), {}, {}, 0.1).match;
    };
    EXPECT_EQ(match(zero), Match::Identical);
    EXPECT_EQ(match(minus), Match::LastBits);
    TerrainEstimate moved = zero;
    moved.height[8] += 0.02;
    moved.height[2] -= 0.05;
    const Differences d = differencesBetween(equalSides(zero), equalSides(moved), {}, {}, 0.1);
    EXPECT_EQ(d.largestBin, 2);
    EXPECT_NEAR(d.largest(), 0.05, 1e-12);
    EXPECT_NEAR(d.side[1][8].height, 0.02, 1e-12);
    EXPECT_EQ(d.match, Match::Other);
}

TEST(Differences, areJudgedOnBothSides)
{
    TerrainEstimate drawn = stepEstimate();
    drawn.draws.assign(4, drawn.height);
    const TwoTrackEstimate plane = equalSides(drawn);
    TwoTrackEstimate sides = plane;
    sides.onePlane = false;
    EXPECT_EQ(differencesBetween(plane, sides, {}, {}, 0.1).match, Match::Other);
    EXPECT_EQ(differencesBetween(sides, sides, {}, {}, 0.1).match, Match::Identical);
    TwoTrackEstimate moved = sides;
    moved.side[1].height[4] += 0.03;
    const Differences d = differencesBetween(sides, moved, {}, {}, 0.1);
    EXPECT_EQ(d.match, Match::Other);
    EXPECT_FALSE(d.onePlane);
    EXPECT_EQ(d.largestSide, 1U);
    EXPECT_EQ(d.largestBin, 4);
    EXPECT_NEAR(d.largest(), 0.03, 1e-12);
    moved = sides;
    moved.side[1].mean[4] += 1e-9;
    EXPECT_EQ(differencesBetween(sides, moved, {}, {}, 0.1).match, Match::LastBits);
}

TEST(Differences, countTouchSensorsAndContradiction)
{
    const TerrainEstimate recorded = clearEstimate();
    const auto likenessAfter = [&](const auto& change) {
        TwoTrackEstimate other = equalSides(recorded);
        change(other.side[1]);
        return differencesBetween(equalSides(recorded), other, {}, {}, 0.1).match;
    };
    using Estimate = TerrainEstimate;
    EXPECT_EQ(likenessAfter([](Estimate&) {}), Match::Identical);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.touch[9] = Touch::Bounded; }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.feltTo += 0.01; }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.feltTo += 1e-9; }), Match::LastBits);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.missing.set(kFirstForceFeature); }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.contradicts = true; }), Match::Other);
}

TEST(Differences, leaveOutATouchThatIsNotRecorded)
{
    const TerrainEstimate now = clearEstimate();
    TerrainEstimate old = now;
    old.touch = unrecordedTouch();
    old.feltTo = binBegin(0);
    TerrainEstimate felt = now;
    felt.feltTo = 0.5;
    const Differences d = differencesBetween(equalSides(old), equalSides(felt), {}, {}, 0.1);
    EXPECT_EQ(d.match, Match::Identical);
    EXPECT_FALSE(d.before.side[0].touchRecorded);
}

TEST(Differences, countTheVerdict)
{
    const TerrainEstimate clear = clearEstimate();
    TerrainEstimate strict = clear;
    strict.settings.rollLimit = 0.01;
    Measurement scene;
    scene.roll = 0.02;
    const Differences d = differencesBetween(equalSides(clear), equalSides(strict), {}, scene, 0.1);
    ASSERT_EQ(d.before.both, StepVerdict::Clear);
    ASSERT_EQ(d.after.both, StepVerdict::CannotTell);
    EXPECT_EQ(d.match, Match::Other) << "the numbers are the same, the answer is not";
}

TEST(Differences, areLastBitsIfNumbersAreNearAndTextsEqual)
{
    TerrainEstimate recorded = stepEstimate();
    recorded.draws.assign(3, Heights{});
    recorded.ess.fill(400.0);
    const auto likenessAfter = [&](const auto& change) {
        TerrainEstimate other = recorded;
        change(other);
        return differencesBetween(equalSides(recorded), equalSides(other), {}, {}, 0.1).match;
    };
    using Estimate = TerrainEstimate;
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.q90[2] += 0.9e-6; }), Match::LastBits);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.draws[2][5] -= 0.9e-6; }), Match::LastBits);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.ess[2] += 3e-4; }), Match::LastBits);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.q90[2] += 1.1e-6; }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.draws[2][5] -= 1.1e-6; }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.ess[2] += 5e-4; }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.sd[2] = std::nan(""); }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.draws.pop_back(); }), Match::Other);
    EXPECT_EQ(likenessAfter([](Estimate& e) { e.warnings.push_back(Message::verbatim("other")); }),
              Match::Other);
}

}  // namespace
}  // namespace terratact
