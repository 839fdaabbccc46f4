#include "core/infer/estimate/touch.h"

#include <gtest/gtest.h>

#include "core/infer/estimate/estimate.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {
namespace {

const RobotModel& absolem()
{
    static const RobotModel robot =
        *readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
    return robot;
}

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
    EXPECT_EQ(e.touch[10], Touch::Felt);
    EXPECT_DOUBLE_EQ(e.feltTo, 0.4);
}

TEST(Touch, namesAreReadBack)
{
    for (const Touch touch : kTouches) EXPECT_EQ(touchFromName(name(touch)), touch);
    EXPECT_EQ(touchFromName("touched"), std::nullopt);
}

}  // namespace
}  // namespace terratact
