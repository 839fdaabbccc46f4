#include "core/sim/posterior_check.h"

#include <gtest/gtest.h>

#include "core/infer/estimate/contradiction.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/rest/rest_pose.h"

namespace terratact {
namespace {

const RobotModel& checkedRobot()
{
    static const RobotModel robot =
        *readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
    return robot;
}

/// Returns the robot's readings on level ground with flippers pressed by 18 N m.
Proprioception levelReadings()
{
    return exactReadings(checkedRobot(), *restPose(checkedRobot(), flatTerrain(6.0), 2.0,
                                                   PressTorque{18.0}, HoldAngle{0.5}));
}

/// The DEM frame's level ground below the robot, tilted by `slope` in every draw.
TerrainEstimate estimateOf(double slope)
{
    TerrainEstimate e;
    const double level = -(checkedRobot().baseHeight + checkedRobot().imu.z);
    for (int bin = 0; bin < kBins; ++bin)
        e.height[static_cast<std::size_t>(bin)] = level + slope * binCentre(bin);
    e.draws.assign(100, e.height);
    return e;
}

TEST(PosteriorCheck, trueGroundAgrees)
{
    const PosteriorCheck check = checkPosterior(estimateOf(0.0), levelReadings(), checkedRobot());
    EXPECT_TRUE(check.agrees);
    EXPECT_EQ(check.rested, 1);  // the first draw that agrees ends the check
    EXPECT_NEAR(check.pitch, 0.0, 0.01);
    EXPECT_NEAR(check.front, 0.0, 0.02);
}

TEST(PosteriorCheck, tiltedGroundContradictsALevelPitch)
{
    TerrainEstimate e = estimateOf(0.3);
    writePosteriorCheck(e, levelReadings(), checkedRobot());
    EXPECT_TRUE(e.contradicts);
    ASSERT_EQ(e.warnings.size(), 1U);
    EXPECT_TRUE(sayContradiction(e.warnings));
    EXPECT_NE(e.warnings[0].english().find("pitch +0° measured, +17° on its ground"),
              std::string::npos)
        << e.warnings[0].english();
}

TEST(PosteriorCheck, oneDrawThatAgreesIsEnough)
{
    TerrainEstimate e = estimateOf(0.3);
    e.draws[0] = estimateOf(0.0).height;
    EXPECT_TRUE(checkPosterior(e, levelReadings(), checkedRobot()).agrees);
}

TEST(PosteriorCheck, heldFlippersAreNotCompared)
{
    Proprioception s = levelReadings();
    s.front = 0.9;
    s.frontCurrent = std::nullopt;
    EXPECT_TRUE(checkPosterior(estimateOf(0.0), s, checkedRobot()).agrees);
    s.frontCurrent = 1.5;
    EXPECT_FALSE(checkPosterior(estimateOf(0.0), s, checkedRobot()).agrees);
}

TEST(PosteriorCheck, canBeCancelled)
{
    struct Enough {};
    EXPECT_THROW((void)checkPosterior(estimateOf(0.0), levelReadings(), checkedRobot(), {},
                                      [] { throw Enough{}; }),
                 Enough);
}

}  // namespace
}  // namespace terratact
