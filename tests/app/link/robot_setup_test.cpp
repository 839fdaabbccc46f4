// Tests the ground and the faults of a simulated robot.
#include "app/link/robot_setup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(RobotGroundTest, withoutATerrainLeadsToAStep)
{
    const auto ground = robotGround("", 1);
    ASSERT_TRUE(ground);
    EXPECT_NEAR(ground->start, kDemoStep - 1.1, 1e-9);
    EXPECT_TRUE(ground->lines.isOnePlane());
    const TerrainProfile& profile = ground->lines.under(0.0);
    const double before = profile.heightAt(kDemoStep - 0.05);
    EXPECT_GT(std::abs(profile.heightAt(kDemoStep + 0.05) - before), 0.05);
}

TEST(RobotGroundTest, variedGroundIsThatOfItsSeed)
{
    const auto heights = [](std::uint64_t seed) {
        const auto ground = robotGround("varied", seed);
        EXPECT_TRUE(ground);
        EXPECT_GE(ground->start, ground->lines.begin() + 0.5) << "room for the rear flippers";
        std::vector<double> sampled;
        for (double x = ground->start; x < ground->start + 3.0; x += 0.1)
            sampled.push_back(ground->lines.under(0.0).heightAt(x));
        return sampled;
    };
    EXPECT_EQ(heights(4), heights(4));
    EXPECT_NE(heights(4), heights(5));
}

TEST(RobotGroundTest, aFileOfLinesDiffersLeftAndRight)
{
    const TemporaryDirectory directory;
    const std::string path = directory.write("lines.csv", "step_m,y_m,heights_m\n"
                                                          "1,0.2,0,0,0.1,0.1\n"
                                                          "1,-0.2,0,0,0,0\n");
    const auto ground = robotGround(path, 1);
    ASSERT_TRUE(ground) << ground.error().text;
    EXPECT_FALSE(ground->lines.isOnePlane());
    EXPECT_NEAR(ground->lines.under(0.2).heightAt(2.5), 0.1, 1e-9);
    EXPECT_NEAR(ground->lines.under(-0.2).heightAt(2.5), 0.0, 1e-9);
    EXPECT_NEAR(ground->start, 0.7, 1e-9);
}

TEST(RobotGroundTest, errorsNameTheProfileFile)
{
    const TemporaryDirectory directory;
    const std::string path = directory.write("bad.csv", "nothing\n");
    EXPECT_TRUE(refused(robotGround(path, 1), path, {}));
}

TEST(RobotFaults, haveANameAndATime)
{
    const auto silence = withFault({}, "silence@12.5");
    ASSERT_TRUE(silence);
    EXPECT_EQ(silence->fault, RobotFault::Silence);
    EXPECT_EQ(silence->faultAt, 12.5);
    EXPECT_EQ(withFault({}, "slow-arm")->faultAt, 0.0) << "from the start";
    const auto stuck = withFault({}, "stuck:pitch@3");
    ASSERT_TRUE(stuck);
    EXPECT_TRUE(stuck->sensorFault);
    EXPECT_EQ(stuck->fault, RobotFault::None);
    EXPECT_EQ(stuck->faultAt, 3.0);
}

TEST(RobotFaults, refusalsListWhatIsKnown)
{
    for (const char* text : {"", "slow", "silence@", "silence@-1", "silence@nan", "silence@3s",
                             "silence@1e9", "stuck:@2"}) {
        const auto options = withFault({}, text);
        ASSERT_FALSE(options) << text;
        for (const RobotFault known : kRobotFaults)
            EXPECT_NE(options.error().text.find(name(known)), std::string::npos) << text;
    }
}

TEST(RobotFaults, refuseALossOfThePose)
{
    EXPECT_TRUE(withFault({}, "lost:front-left-current@3"));
    for (const char* text : {"lost:pitch", "lost:attitude@3", "lost:angles"}) {
        const auto options = withFault({}, text);
        ASSERT_FALSE(options) << text;
        EXPECT_NE(options.error().text.find("only currents, forces and odometry can be lost"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace terratact
