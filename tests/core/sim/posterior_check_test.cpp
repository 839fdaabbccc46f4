#include "core/sim/posterior_check.h"

#include <gtest/gtest.h>

#include "core/infer/estimate/contradiction.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/rest/rest_pose.h"
#include "core/sim/rest/two_track_rest.h"
#include "core/sim/two_track_check.h"

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
    EXPECT_TRUE(haveContradiction(e.warnings));
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

/// Readings on two lines, the right one lower by `drop`, with flippers pressed by 9 N m each.
TwoTrackReadings readingsOnSides(double drop)
{
    TerrainProfile lower({{0.0, -drop}, {6.0, -drop}});
    const GroundLines ground({{0.2, flatTerrain(6.0)}, {-0.2, lower}});
    return exactReadings(
        checkedRobot(),
        *restPose(checkedRobot(), ground, 2.0, flipperDrives(PressTorque{18.0}, HoldAngle{0.5})));
}

/// Returns the level estimate, with the right side lower by `drop` in every draw.
TwoTrackEstimate sidesOf(double drop)
{
    TwoTrackEstimate e{.side = {estimateOf(0.0), estimateOf(0.0)}};
    const double half = drop / 2.0;  // the IMU is in the middle
    for (double& h : e.side[0].height) h += half;
    for (double& h : e.side[1].height) h -= half;
    for (TerrainEstimate& side : e.side) side.draws.assign(100, side.height);
    return e;
}

TEST(TwoTrackCheck, trueGroundOfBothSidesAgrees)
{
    for (const double drop : {0.0, 0.06, -0.1}) {
        const TwoTrackReadings s = readingsOnSides(drop);
        const TwoTrackCheck check = checkPosterior(sidesOf(drop), s, checkedRobot());
        EXPECT_TRUE(check.agrees) << drop;
        EXPECT_EQ(check.rested, 1) << drop;
        EXPECT_NEAR(check.roll, s.roll, 0.02) << drop;
        EXPECT_NEAR(check.front[1], s.flippers[1], 0.05) << drop;
    }
}

TEST(TwoTrackCheck, levelGroundContradictsARoll)
{
    const TwoTrackReadings s = readingsOnSides(0.1);
    ASSERT_GT(s.roll, 0.2);
    TwoTrackEstimate e = sidesOf(0.0);
    writePosteriorCheck(e, measurementOf(s), checkedRobot());
    for (const TerrainEstimate& side : e.side) {
        EXPECT_TRUE(side.contradicts);
        EXPECT_TRUE(haveContradiction(side.warnings));
    }
    EXPECT_NE(e.side[0].warnings[0].english().find("roll +12°"), std::string::npos)
        << e.side[0].warnings[0].english();
    e = sidesOf(0.1);
    writePosteriorCheck(e, measurementOf(s), checkedRobot());
    EXPECT_FALSE(e.side[0].contradicts);
}

TEST(TwoTrackCheck, aMissingCurrentIsThatOfTheOtherSide)
{
    TwoTrackReadings complete = readingsOnSides(0.06);
    complete.currents[1] = complete.currents[0];
    for (const std::size_t motor : {0U, 1U}) {
        TwoTrackReadings lacking = complete;
        lacking.currents[motor].reset();
        EXPECT_EQ(checkPosterior(sidesOf(0.06), lacking, checkedRobot()),
                  checkPosterior(sidesOf(0.06), complete, checkedRobot()));
    }
}

TEST(TwoTrackCheck, anEstimateOfOnePlaneHasThatOfOnePlane)
{
    const Measurement line = measurementOf(readingsOnSides(0.0));
    TerrainEstimate plane = estimateOf(0.3);
    writePosteriorCheck(plane, proprioception(line), checkedRobot());
    TwoTrackEstimate both = equalSides(estimateOf(0.3));
    writePosteriorCheck(both, line, checkedRobot());
    EXPECT_TRUE(plane.contradicts);
    EXPECT_EQ(both, equalSides(plane));
}

}  // namespace
}  // namespace terratact
