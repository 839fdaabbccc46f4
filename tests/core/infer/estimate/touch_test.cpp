#include "core/infer/estimate/touch.h"

#include <gtest/gtest.h>

#include "core/infer/estimate/estimate.h"
#include "core/terrain/body_ceiling.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

/// Level robot, flippers flat: the elements lie at +0.30, 0.35, 0.41, 0.46, 0.51 and 0.56 m.
PressedBins pressedBy(std::array<std::optional<double>, kForceElements> force)
{
    Proprioception s;
    s.force = force;
    return pressedBins(absolem(), s, bodyCeiling(absolem(), s.pitch, s.front, s.rear));
}

TEST(Touch, loadedElementsMakeTheirBinsFelt)
{
    const PressedBins p = pressedBy({16.0, 10.0, 10.0, 10.0, 10.0, 5.0});
    for (const std::size_t bin : {6U, 7U, 8U}) EXPECT_EQ(p.touch[bin], Touch::Felt) << bin;
    EXPECT_EQ(p.touch[9], Touch::FeltInPart);  // the tip covers a part of it
    EXPECT_EQ(p.touch[10], Touch::NotFelt);
    EXPECT_NEAR(p.feltTo, 0.563, 0.002);
    EXPECT_EQ(p.firstOfFlipper, 6);
}

TEST(Touch, hoveringFlipperIsBoundedNotFelt)
{
    const PressedBins p = pressedBy({0.0, 0.3, 0.2, 0.5, 0.8, 0.1});
    for (const std::size_t bin : {6U, 7U, 8U}) EXPECT_EQ(p.touch[bin], Touch::Bounded) << bin;
    EXPECT_EQ(p.touch[9], Touch::NotFelt);
    EXPECT_DOUBLE_EQ(p.feltTo, binBegin(0));
}

TEST(Touch, unloadedStretchBetweenLoadsIsNotFelt)
{
    const PressedBins p = pressedBy({27.0, 0.0, 0.4, 12.0, 16.0, 7.0});
    EXPECT_EQ(p.touch[6], Touch::FeltInPart);
    EXPECT_EQ(p.touch[7], Touch::Bounded);
    EXPECT_EQ(p.touch[8], Touch::FeltInPart);  // the element before it carries nothing
}

TEST(Touch, neighbourOfAPointLoadIsNotAPress)
{
    const PressedBins p = pressedBy({0.0, 0.0, 5.0, 58.0, 0.0, 0.0});
    EXPECT_EQ(p.touch[7], Touch::Bounded);
    EXPECT_EQ(p.touch[8], Touch::FeltInPart);
}

TEST(Touch, missingElementBetweenLoadsCountsAsLoaded)
{
    PressedBins p = pressedBy({16.0, 10.0, std::nullopt, 10.0, 10.0, 5.0});
    EXPECT_EQ(p.touch[7], Touch::Felt);
    p = pressedBy({16.0, 10.0, std::nullopt, 0.0, 10.0, 5.0});
    EXPECT_NE(p.touch[7], Touch::Felt);
    p = pressedBy({});
    EXPECT_EQ(p.touch[7], Touch::Bounded);
}

std::vector<GroundStretch> stretchesOf(std::array<std::optional<double>, kForceElements> force)
{
    Proprioception s;
    s.force = force;
    return pressedStretches(absolem(), s);
}

TEST(Touch, stretchesReachFromElementToElement)
{
    const auto whole = stretchesOf({16.0, 10.0, 10.0, 10.0, 10.0, 5.0});
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_NEAR(whole[0].from, 0.24, 0.01);  // the flippers' edge and kUnsensedWithin
    EXPECT_NEAR(whole[0].to, 0.563, 0.002);
    // The ground under the first element lies too low: it is felt from the second one on.
    const auto later = stretchesOf({2.0, 10.0, 10.0, 10.0, 10.0, 5.0});
    for (const GroundStretch& stretch : later) EXPECT_GT(stretch.from, 0.34);
    EXPECT_TRUE(stretchesOf({0.0, 0.3, 0.2, 0.5, 0.8, 0.1}).empty()) << "a hovering flipper";
    EXPECT_TRUE(stretchesOf({0.0, 0.0, 5.0, 58.0, 0.0, 0.0}).empty()) << "a point load";
}

TEST(Touch, everyFeltBinLiesWithinItsStretch)
{
    const std::array<std::optional<double>, kForceElements> force{16.0, 10.0, 10.0,
                                                                  10.0, 10.0, 5.0};
    const FeltCells cells = cellsOf(stretchesOf(force));
    const PressedBins p = pressedBy(force);
    for (std::size_t bin = 6; bin < kBins; ++bin)
        EXPECT_EQ(cells[bin] == kAllCells, p.touch[bin] == Touch::Felt) << bin;
}

TEST(Touch, cellsLieWithinOneStretch)
{
    const FeltCells cells = cellsOf({{0.255, 0.283}, {0.283, 0.36}});
    // 0.26 … 0.28 in the first stretch, 0.29 … 0.35 in the second; the border's cell in neither
    EXPECT_EQ(cells[6], 0b1111110110);
    EXPECT_EQ(cells[7], 0b0000000001);
    EXPECT_EQ(cells[5], 0);
}

TEST(Touch, earlierAndPresentPressMakeABinRemembered)
{
    TerrainEstimate e;
    e.touch.fill(Touch::Bounded);
    e.touch[7] = Touch::Felt;
    e.feltTo = 0.4;
    FeltCells earlier{}, now{};
    earlier[5] = earlier[7] = earlier[9] = kAllCells;
    earlier[6] = 0b0000011111;
    now[6] = 0b1111110000;
    now[8] = kAllCells;
    earlier[10] = kAllCells >> 1U;
    addRemembered(e, earlier, now);
    EXPECT_EQ(e.touch[5], Touch::Bounded) << "behind the flippers it decides nothing";
    EXPECT_EQ(e.touch[6], Touch::Remembered);
    EXPECT_EQ(e.touch[7], Touch::Felt);
    EXPECT_EQ(e.touch[8], Touch::Bounded) << "nothing was felt earlier";
    EXPECT_EQ(e.touch[9], Touch::Remembered);
    EXPECT_EQ(e.touch[10], Touch::Bounded) << "a cell is missing";
    e.touch.fill(Touch::Bounded);
    e.feltTo = 0.2;
    addRemembered(e, earlier, now);
    EXPECT_EQ(e.touch[9], Touch::Bounded) << "the flippers press on nothing now";
}

TEST(Touch, armAndTracksMakeBinsFelt)
{
    TerrainEstimate e;
    e.ceiling.fill(0.0);
    e.q10.fill(-0.010);
    e.q10[2] = -0.020;
    e.origin[10] = Origin::Arm;
    PressedBins pressed;
    pressed.touch.fill(Touch::Bounded);
    pressed.feltTo = 0.4;
    writeTouch(e, pressed);
    EXPECT_EQ(e.touch[1], Touch::Felt);
    EXPECT_EQ(e.touch[2], Touch::Bounded);
    EXPECT_EQ(e.touch[7], Touch::Bounded);  // a flipper needs loaded elements
    EXPECT_EQ(e.touch[10], Touch::FeltInPart) << "a fall may begin beside the arm's point";
    EXPECT_DOUBLE_EQ(e.feltTo, 0.4);
}

TEST(Touch, armPointsJoinTheGroundBetweenThem)
{
    TerrainEstimate e;
    e.ceiling.fill(0.0);
    e.q10.fill(-0.1);
    PressedBins pressed;
    pressed.touch.fill(Touch::Bounded);
    pressed.feltTo = 0.54;
    pressed.cells = cellsOf({{0.25, 0.53}});
    pressed.touch[6] = pressed.touch[7] = Touch::Felt;
    pressed.touch[8] = Touch::FeltInPart;
    for (const int bin : {8, 9}) e.origin[static_cast<std::size_t>(bin)] = Origin::Arm;
    writeTouch(e, pressed);
    EXPECT_EQ(e.touch[8], Touch::Felt) << "felt to 0.53 m, and the arm's point is at 0.60 m";
    EXPECT_EQ(e.touch[9], Touch::FeltInPart) << "nothing was felt from 0.60 to 0.65 m";
    e.origin[10] = Origin::Arm;
    writeTouch(e, pressed);
    EXPECT_EQ(e.touch[9], Touch::Felt) << "between three points";
    EXPECT_EQ(e.touch[10], Touch::FeltInPart);
    e.origin[9] = Origin::Sampled;
    writeTouch(e, pressed);
    EXPECT_EQ(e.touch[8], Touch::FeltInPart) << "the next point is too far away";
    EXPECT_EQ(e.touch[9], Touch::Bounded);
}

TEST(Touch, anArmPointJoinsWhatWasFeltEarlier)
{
    TerrainEstimate e;
    e.touch.fill(Touch::Bounded);
    e.feltTo = 0.4;
    e.origin[9] = Origin::Arm;
    FeltCells earlier{};
    earlier[7] = kAllCells;
    earlier[8] = 0b0000111111;  // to 0.51 m
    addRemembered(e, earlier, {});
    EXPECT_EQ(e.touch[8], Touch::Remembered);
    earlier[8] = 0b0000000111;  // to 0.48 m: 0.12 m before the point
    e.touch[8] = Touch::Bounded;
    addRemembered(e, earlier, {});
    EXPECT_EQ(e.touch[8], Touch::Bounded);
}

TEST(Touch, namesAreReadBack)
{
    for (const Touch touch : kTouches) EXPECT_EQ(touchFromName(name(touch)), touch);
    EXPECT_EQ(touchFromName("touched"), std::nullopt);
}

}  // namespace
}  // namespace terratact
