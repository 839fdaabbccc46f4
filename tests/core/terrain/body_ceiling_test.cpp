#include "core/terrain/body_ceiling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/robot/kinematics.h"
#include "core/sim/drive.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/rest/rest_pose.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

TEST(BodyCeiling, isInfiniteWherePartOfTheBinIsFree)
{
    const Heights flat = bodyCeiling(absolem(), 0.0, 0.0, 0.0);
    for (std::size_t i = 0; i <= 8; ++i) EXPECT_TRUE(std::isfinite(flat[i])) << i;
    EXPECT_TRUE(std::isinf(flat[9]));  // the tip ends inside bin 0.6
    EXPECT_TRUE(std::isinf(flat[10]));
    const Heights upright = bodyCeiling(absolem(), 0.0, 1.9, 0.0);
    EXPECT_TRUE(std::isinf(upright[7]));
}

TEST(BodyCeiling, ofTheLevelRobotIsTheGroundItStandsOn)
{
    const Heights flat = bodyCeiling(absolem(), 0.0, 0.0, 0.0);
    for (std::size_t i = 1; i <= 8; ++i) EXPECT_NEAR(flat[i], -0.240, 5e-4) << i;
}

TEST(SideCeiling, ofALevelSymmetricRobotIsThatOfThePlane)
{
    TwoTrackReadings s;
    s.pitch = 0.1;
    s.flippers = {0.3, 0.3, -0.1, -0.1};
    for (const Side side : {Side::Left, Side::Right})
        EXPECT_EQ(sideCeiling(absolem(), s, side), bodyCeiling(absolem(), 0.1, 0.3, -0.1));
}

TEST(SideCeiling, risesWithItsSide)
{
    TwoTrackReadings s;
    s.roll = 0.2;
    const Heights left = sideCeiling(absolem(), s, Side::Left);
    const Heights right = sideCeiling(absolem(), s, Side::Right);
    EXPECT_NEAR(left[3] - right[3], 2.0 * 0.1985 * std::sin(0.2), 1e-9);  // tracks
    EXPECT_NEAR(left[7] - right[7], 2.0 * 0.272 * std::sin(0.2), 1e-9);   // flippers
    EXPECT_EQ(sideCeiling(absolem(), mirrored(s), Side::Right), left);
}

TEST(BodyCeiling, isAboveTheTerrainOfEveryRestPose)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(11);
    int poses = 0;
    for (int run = 0; run < 25; ++run) {
        const TerrainProfile terrain = randomVariedTerrain(rng);
        const DriveStyle style = randomDriveStyle(rng);
        for (const double x : stopsOver(terrain, 0.37)) {
            const auto rest = restPose(robot, terrain, x, PressTorque{style.pressTorque},
                                       HoldAngle{style.rearAngle});
            if (!rest) continue;
            ++poses;
            const Heights truth = binHeights(terrain, imuPosition(robot, rest->pose));
            const Heights ceiling =
                bodyCeiling(robot, rest->pose.pitch, rest->pose.front, rest->pose.rear);
            for (std::size_t i = 0; i < kBins; ++i)
                EXPECT_LE(truth[i], ceiling[i] + 1e-4)
                    << "run " << run << " x " << x << " bin " << i;
        }
    }
    EXPECT_GT(poses, 250);
}

TEST(BodyCeiling, refusesWhatIsNotFinite)
{
    EXPECT_THROW((void)bodyCeiling(absolem(), std::nan(""), 0.0, 0.0), std::invalid_argument);
}

TEST(RobotOutline, surroundsTheShapesThatMakeTheCeiling)
{
    const RobotModel robot = absolem();
    const Outline outline = robotOutline(robot, 0.2, 0.5, -0.1);
    const RobotShape shape = shapeAt(robot, poseInDem(robot, 0.2, 0.5, -0.1));
    for (const OutlinePart& part : outline) {
        double lowest = 1.0;
        double x = 0.0;
        for (const auto& p : part.points)
            if (p[1] < lowest) {
                lowest = p[1];
                x = p[0];
            }
        EXPECT_NEAR(lowerEnvelope(shape, x), std::min(lowest, lowerEnvelope(shape, x)), 1e-3);
        EXPECT_LE(lowerEnvelope(shape, x), lowest + 1e-9);
    }
    EXPECT_EQ(outline.back().kind, OutlinePart::Kind::FrontFlipper);
}

}  // namespace
}  // namespace terratact
