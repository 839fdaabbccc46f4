// Tests heights and alignment on generated clouds over known ground.
#include "core/clouds/cloud_truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/clouds/cloud_alignment.h"
#include "core/clouds/made_cloud.h"
#include "core/sim/ground/random_ground.h"
#include "core/sim/rest/two_track_rest.h"
#include "core/terrain/ground_lines.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

TerrainProfile flat(double height)
{
    return TerrainProfile({{-2.0, height}, {4.0, height}});
}

/// A drive over ground with a scene every 0.25 m, seen by a cloud.
struct LaserDrive {
    LaserDrive(GroundLines lines, const MadeCloud& made, const CloudPose& drive = {},
               double pitchError = 0.0, std::size_t most = 1000)
        : ground(std::move(lines))
    {
        std::mt19937_64 rng(7);
        std::vector<ScenePlace> places;
        std::vector<CloudPoint> points =
            groundCloud(robot, ground, drive, ground.begin(), ground.end(), made, rng);
        RestStart start;
        for (double x = ground.begin() + 0.7; x < ground.end() - 0.9 && places.size() < most;
             x += 0.25) {
            const auto rest =
                restPose(robot, ground, x, flipperDrives(PressTorque{18.0}, HoldAngle{0.2}), start);
            if (!rest) continue;
            start = {rest->pose.pitch, rest->pose.roll};
            const CloudPose base = drive.with(basePose(robot, rest->pose));
            TwoTrackReadings s;
            s.pitch = rest->pose.pitch + pitchError;
            s.roll = rest->pose.roll;
            s.flippers = rest->pose.flippers;
            places.push_back(placeOf(robot, places.size(), s, base));
            const auto own = robotCloud(robot, base, made.own, rng);
            points.insert(points.end(), own.begin(), own.end());
            const Vec2 imu = imuPosition(robot, rest->pose);
            truth.push_back({sideHeights(ground, robot, Side::Left, imu),
                             sideHeights(ground, robot, Side::Right, imu)});
        }
        grid = *SceneGrid::over(robot, std::move(places));
        grid->add(points);
    }

    /// Errors of all known bins [m], and errors over sd.
    struct Errors {
        double bias = 0.0, rms = 0.0, rmsOverSd = 0.0;
        std::size_t known = 0, all = 0;
    };
    Errors errors(const TruthRule& rule = {}, bool align = false) const
    {
        const auto alignment = alignmentOf(*grid, robot, rule);
        Errors e;
        for (std::size_t p = 0; p < truth.size(); ++p)
            for (const Side side : {Side::Left, Side::Right}) {
                const CloudCorrection c =
                    align ? alignment->at(grid->places()[p].heading) : CloudCorrection{};
                const SideTruth found = sideTruth(*grid, robot, p, side, c, rule);
                for (std::size_t i = 0; i < kBins; ++i) {
                    ++e.all;
                    if (!found.at(i).height) continue;
                    ++e.known;
                    const double error = *found.at(i).height - truth[p][indexOf(side)].at(i);
                    e.bias += error;
                    e.rms += error * error;
                    e.rmsOverSd += std::pow(error / found.at(i).sd, 2);
                }
            }
        const auto n = static_cast<double>(e.known);
        return {e.bias / n, std::sqrt(e.rms / n), std::sqrt(e.rmsOverSd / n), e.known, e.all};
    }

    RobotModel robot = absolem();
    GroundLines ground;
    std::vector<std::array<Heights, 2>> truth;
    std::optional<SceneGrid> grid;
};

GroundLines steps()
{
    const TerrainProfile left({{-2, 0}, {0, 0}, {0, 0.15}, {1, 0.15}, {2, 0.05}, {4, 0.05}});
    const TerrainProfile right({{-2, 0}, {0.1, 0}, {0.1, 0.1}, {1, 0.12}, {2, 0}, {4, 0.05}});
    const RobotModel robot = absolem();
    const double t = robot.lateral.trackY, f = robot.lateral.flipperY;
    return GroundLines({{t, left}, {f, left}, {-t, right}, {-f, right}});
}

TEST(LaserTruth, noiseOfPointsAveragesOut)
{
    const LaserDrive drive(steps(), {.noise = 0.01});
    const auto e = drive.errors();
    EXPECT_EQ(e.known, e.all);
    EXPECT_LT(std::abs(e.bias), 0.001);
    EXPECT_LT(e.rms, 0.006);
    EXPECT_LT(e.rmsOverSd, 2.0);
}

TEST(LaserTruth, holesBecomeUnknownNotWrong)
{
    const LaserDrive drive(steps(), {.noise = 0.01, .holes = 0.3});
    const auto e = drive.errors();
    EXPECT_LT(e.known, e.all - e.all / 10);
    EXPECT_GT(e.known, e.all / 2);
    EXPECT_LT(e.rms, 0.01);
    EXPECT_LT(e.rmsOverSd, 2.0);
}

TEST(LaserTruth, theRobotsOwnPointsAreLeftOut)
{
    const LaserDrive drive(steps(), {.noise = 0.01, .own = 3000});
    const auto e = drive.errors();
    EXPECT_LT(std::abs(e.bias), 0.002);
    EXPECT_LT(e.rms, 0.01);
    EXPECT_GT(drive.errors({.ownMargin = 1.0}).rms, 0.02) << "the margin is what leaves them out";
}

TEST(LaserTruth, anyHeadingAndPlaceGivesTheSame)
{
    const LaserDrive there(
        steps(), {.noise = 0.0},
        {{300, -200, 50}, Eigen::Quaterniond(Eigen::AngleAxisd(2.1, Eigen::Vector3d::UnitZ()))});
    const LaserDrive here(steps(), {.noise = 0.0});
    EXPECT_EQ(there.errors().known, here.errors().known);
    EXPECT_NEAR(there.errors().rms, here.errors().rms, 1e-3);
}

TEST(LaserTruth, offsetIsFoundAndRemoved)
{
    for (const double offset : {-0.04, 0.04, 0.2}) {
        const LaserDrive drive(steps(), {.noise = 0.01, .offset = offset});
        const auto a = alignmentOf(*drive.grid, drive.robot, {});
        ASSERT_TRUE(a);
        EXPECT_NEAR(a->correction.offset, -offset, 0.006) << offset;
        EXPECT_LT(a->scatter, 0.01);
        const auto e = drive.errors({}, true);
        EXPECT_LT(e.rms, 0.01) << offset;
        EXPECT_GT(drive.errors().rms, 0.02);
    }
}

TEST(LaserTruth, tiltOfTheRobotIsReported)
{
    const double error = 0.03;
    const LaserDrive drive(GroundLines(flat(0.0)), {.noise = 0.005}, {}, error);
    const auto a = alignmentOf(*drive.grid, drive.robot, {});
    ASSERT_TRUE(a);
    EXPECT_FALSE(a->isOfMap);
    EXPECT_NEAR(a->correction.tiltX, error, 0.004);
    EXPECT_NEAR(a->correction.tiltY, 0.0, 0.004);
    EXPECT_NEAR(a->pitchApart, error, 1e-6);
}

TEST(LaserTruth, percentileFindsGroundBelowPlants)
{
    LaserDrive drive(GroundLines(flat(0.0)), {.density = 8000, .noise = 0.005}, {}, 0.0, 1);
    std::mt19937_64 rng(3);
    std::uniform_real_distribution<double> x(-2, 4), y(-0.4, 0.4), z(0.02, 0.3);
    std::vector<CloudPoint> plants;
    for (int i = 0; i < 60'000; ++i) plants.push_back({x(rng), y(rng), z(rng)});
    drive.grid->add(plants);
    const TruthRule plain{.maxSd = 0.1}, low{.percentile = 15.0, .maxSd = 0.1};
    EXPECT_GT(drive.errors(plain).bias, 0.01);
    EXPECT_LT(std::abs(drive.errors(low).bias), 0.006);
}

TEST(LaserTruth, theGroundBelowATableCounts)
{
    LaserDrive drive(GroundLines(flat(0.0)), {.noise = 0.005});
    std::vector<CloudPoint> table;
    for (double x = -2; x < 4; x += 0.01)
        for (double y = -0.4; y < 0.4; y += 0.01) table.push_back({x, y, 0.6});
    drive.grid->add(table);
    const auto e = drive.errors();
    EXPECT_EQ(e.known, e.all);
    EXPECT_LT(e.rms, 0.01);
}

TEST(LaserTruth, aScanLeavesOutTheRobotsBox)
{
    const RobotModel robot = absolem();
    SceneGrid grid = *SceneGrid::over(robot, {placeOf(robot, 0, {}, {})});
    const std::vector<CloudPoint> points{{0.1, 0.2, 0.3}, {5, 0, 0}};
    grid.addScan(points, {}, {});
    EXPECT_EQ(grid.ownPoints(), 1U);
}

TEST(LaserTruth, tooManyScenesAreRefused)
{
    const RobotModel robot = absolem();
    const auto grid = SceneGrid::over(robot, std::vector<ScenePlace>(60'000));
    ASSERT_FALSE(grid);
    EXPECT_NE(grid.error().text.find("--run"), std::string::npos);
}

TEST(LaserTruth, aCellKeepsABoundedFairSample)
{
    const RobotModel robot = absolem();
    SceneGrid grid = *SceneGrid::over(robot, {placeOf(robot, 0, {}, {})});
    const double y = robot.lateral.trackY;
    std::vector<CloudPoint> points;
    for (int i = 0; i < 100'000; ++i)
        points.push_back({robot.imu.x + 0.005, y, robot.imu.z - 0.3 + 1e-6 * i});
    grid.add(points);
    std::size_t cell = 0;
    while (grid.cellX(cell) < 0.0) ++cell;
    const auto kept = grid.heights(0, TruthLine::LeftTrack, cell);
    EXPECT_EQ(grid.count(0, TruthLine::LeftTrack, cell), 100'000U);
    EXPECT_EQ(kept.size(), SceneGrid::kMaxPerCell);
    double mean = 0.0;
    for (const float h : kept) mean += h / static_cast<double>(kept.size());
    EXPECT_NEAR(mean, -0.25, 0.015) << "early points are as likely as late ones";
}

TEST(LaserTruth, manyScenesOverOnePlaceAreRefused)
{
    const RobotModel robot = absolem();
    const auto over = [&](std::size_t scenes, double spacing) {
        std::vector<ScenePlace> places;
        for (std::size_t i = 0; i < scenes; ++i)
            places.push_back(
                placeOf(robot, i, {}, {.place = {spacing * static_cast<double>(i), 0.0, 0.0}}));
        return SceneGrid::over(robot, std::move(places));
    };
    const auto grid = over(SceneGrid::kMaxPerPlace + 1, 0.0);
    ASSERT_FALSE(grid);
    EXPECT_NE(grid.error().text.find("501 scenes lie over the same ground"), std::string::npos)
        << grid.error().text;
    EXPECT_TRUE(over(SceneGrid::kMaxPerPlace + 1, 0.1));
}

}  // namespace
}  // namespace terratact
