// Robots and grounds with extreme geometry: results are right or refused with a text, never a NaN.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/rest/rest_pose.h"
#include "core/sim/rest/skin_contact.h"
#include "core/terrain/body_ceiling.h"
#include "core/terrain/kinematic_reconstruction.h"
#include "tests/support/absolem.h"
#include "tests/support/skin_hits.h"

namespace terratact {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// The same cases in every run; RC_PARAMS="seed=…" tries others.
const int kSeeded = setenv("RC_PARAMS", "seed=20150205", 0);

constexpr double kDegree = std::numbers::pi / 180.0;

const RobotModel& robot()
{
    static const RobotModel model = absolem();
    return model;
}

/// Returns a robot whose parts are all points.
RobotModel pointRobot()
{
    RobotModel point = robot();
    point.trackAxle = point.trackRadius = 0.0;
    for (FlipperGeometry* f : {&point.front, &point.rear})
        f->pivotRadius = f->tipRadius = f->axleDistance = f->comDistance = 0.0;
    for (auto& polygon : point.body) polygon.assign(3, Vec2{0.0, 0.0});
    return point;
}

/// Returns the lowest of many discs between the two circles, whose union is a tapered hull.
double lowestDisc(const TaperedHull& hull, double x)
{
    constexpr int kDiscs = 20000;
    double lowest = kInfinity;
    for (int k = 0; k <= kDiscs; ++k) {
        const double t = static_cast<double>(k) / kDiscs;
        const double r = hull.ra + t * (hull.rb - hull.ra);
        const double dx = x - (hull.a.x + t * (hull.b.x - hull.a.x));
        if (std::abs(dx) > r) continue;
        const double z = hull.a.z + t * (hull.b.z - hull.a.z);
        lowest = std::min(lowest, z - std::sqrt(r * r - dx * dx));
    }
    return lowest;
}

double anyIn(double least, double most)
{
    const auto share = *rc::gen::inRange(0, 1000001);
    return least + (most - least) * share * 1e-6;
}

/// Returns 0 in every fourth case.
double anySize(double most)
{
    return *rc::gen::inRange(0, 4) == 0 ? 0.0 : anyIn(0.0, most);
}

RC_GTEST_PROP(LowerBoundary, ofAnyTwoCirclesIsTheBottomOfTheDiscsBetweenThem, ())
{
    TaperedHull hull{{0.0, 0.0}, {0.0, 0.0}, anySize(0.3), anySize(0.3)};
    const double length = anySize(0.5);
    const double angle = anyIn(-180.0, 180.0) * kDegree;
    hull.b = {length * std::cos(angle), length * std::sin(angle)};
    const double x = anyIn(-0.8, 0.8);
    const double got = lowerBoundary(hull, x);
    const double expected = lowestDisc(hull, x);
    RC_ASSERT(!std::isnan(got));
    if (std::isfinite(got) && std::isfinite(expected)) {
        RC_ASSERT(got <= expected + 1e-12);
        // The discs leave gaps of a fraction of a millimetre where the hull is steep.
        RC_ASSERT(got >= lowestDisc(hull, x - 1e-4) - 0.02 || got >= expected - 0.02);
    }
}

/// Mean of the lower envelope over a bin, with three points per millimetre; one of them is the
/// midpoint rule's.
struct Envelope {
    double mean = 0.0;
    int uncovered = 0;  ///< points without a part above
};

Envelope envelopeOver(const RobotShape& shape, int bin)
{
    constexpr int kPoints = 300;
    Envelope over;
    double sum = 0.0;
    for (int k = 0; k < kPoints; ++k) {
        const double x = binBegin(bin) + kBinWidth * (k + 0.5) / kPoints;
        double lowest = kInfinity;
        for (const TaperedHull& part : {shape.track, shape.front, shape.rear})
            lowest = std::min(lowest, lowerBoundary(part, x));
        for (const auto& polygon : shape.body) lowest = std::min(lowest, lowerBoundary(polygon, x));
        if (std::isfinite(lowest))
            sum += lowest;
        else
            ++over.uncovered;
    }
    over.mean = sum / (kPoints - over.uncovered);
    return over;
}

/// Returns the fault of the robot's ceilings and outline in this pose; empty: none. Angles in
/// degrees.
std::string faultOf(double pitch, double front, double rear)
{
    const double p = pitch * kDegree, f = front * kDegree, r = rear * kDegree;
    const Heights ceiling = bodyCeiling(robot(), p, f, r);
    const RobotShape shape = shapeAt(robot(), poseInDem(robot(), p, f, r));
    for (int i = 0; i < kBins; ++i) {
        const double c = ceiling[static_cast<std::size_t>(i)];
        const Envelope expected = envelopeOver(shape, i);
        const std::string bin = "bin " + std::to_string(i);
        if (std::isnan(c)) return bin + ": NaN";
        if (!std::isfinite(c) && expected.uncovered == 0) return bin + ": covered, but infinite";
        if (!std::isfinite(c)) continue;
        // Gaps of less than a millimetre, two points each.
        if (expected.uncovered > 8) return bin + ": not covered, but finite";
        if (std::abs(c) >= 2.0 || std::abs(c - expected.mean) >= 0.02)
            return bin + ": " + std::to_string(c) + " is not " + std::to_string(expected.mean);
    }
    for (const OutlinePart& part : robotOutline(robot(), p, f, r))
        for (const auto& point : part.points)
            if (!std::isfinite(point[0]) || !std::isfinite(point[1])) return "outline not finite";
    return {};
}

RC_GTEST_PROP(BodyCeiling, ofAnyPoseIsTheMeanOfTheLowerEnvelopeAndNeverNaN, ())
{
    const double pitch = anyIn(-89.0, 89.0);
    const double front = anyIn(-180.0, 180.0);
    RC_ASSERT(faultOf(pitch, front, anyIn(-180.0, 180.0)) == std::string());
}

TEST(BodyCeiling, isTheMeanOfTheLowerEnvelopeAtExtremePoses)
{
    for (const double pitch : {-89.0, -45.0, 0.0, 45.0, 89.0})
        for (const double front : {-180.0, -90.0, 0.0, 90.0, 180.0})
            for (const double rear : {-180.0, -90.0, 0.0, 90.0, 180.0})
                EXPECT_EQ(faultOf(pitch, front, rear), "")
                    << "pitch " << pitch << ", front " << front << ", rear " << rear;
}

TEST(BodyCeiling, underAVerticalWallOfTheBodyIsItsLowerEnd)
{
    EXPECT_EQ(lowerBoundary(std::vector<Vec2>{{0.1, -0.2}, {0.1, 0.4}, {0.1, 0.9}}, 0.1), -0.2);
    EXPECT_EQ(
        lowerBoundary(std::vector<Vec2>{{0.1, -0.2}, {0.1, 0.4}, {0.5, 0.4}, {0.5, -0.2}}, 0.1),
        -0.2);
    for (const double pitch : {-90.0, 90.0}) {  // the body's sides are then vertical or horizontal
        const Heights c = bodyCeiling(robot(), pitch * kDegree, 0.0, 0.0);
        for (const double x : c) EXPECT_FALSE(std::isnan(x)) << pitch;
    }
}

TEST(Robot, ofPointsGivesNoNaN)
{
    const RobotModel point = pointRobot();
    ASSERT_EQ(kSeeded, 0);
    EXPECT_EQ(point.front.taper(), 0.0);
    EXPECT_EQ(point.front.edgeLength(), 0.0);
    for (const double angle : {-180.0, -90.0, 0.0, 33.0, 180.0}) {
        for (const double c : bodyCeiling(point, 0.3, angle * kDegree, angle * kDegree))
            EXPECT_EQ(c, kInfinity);  // nothing covers a whole bin
        for (const OutlinePart& part : robotOutline(point, 0.3, angle * kDegree, 0.0))
            for (const auto& p : part.points)
                ASSERT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]));
    }
    Proprioception s;
    s.force.fill(20.0);
    for (const Contact& c : reconstructContacts(point, s, 2.0, false).contacts)
        EXPECT_TRUE(std::isfinite(c.height));
}

TEST(RestPose, ofARobotOfPointsIsFiniteOrRefused)
{
    const auto rest =
        restPose(pointRobot(), stepTerrain(0.2, 1.0, 3.0), 1.0, PressTorque{18.0}, HoldAngle{0.2});
    if (!rest) {
        EXPECT_GT(rest.error().text.size(), 20U);
        return;
    }
    EXPECT_TRUE(std::isfinite(rest->energy) && std::isfinite(rest->pose.base.z));
    for (const double f : elementForces(pointRobot(), *rest)) EXPECT_TRUE(std::isfinite(f));
}

TEST(SkinHull, isADiscIfOneCircleContainsTheOther)
{
    for (const TaperedHull& hull : {TaperedHull{{0.0, 0.0}, {0.05, 0.0}, 0.2, 0.1},
                                    TaperedHull{{0.05, 0.0}, {0.0, 0.0}, 0.1, 0.2},
                                    TaperedHull{{0.0, 0.0}, {0.0, 0.0}, 0.2, 0.2}}) {
        const auto hit = hitOf(SkinHull(hull, 0.001), {0.0, -0.19});
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->depth, 0.011, 1e-12);
        EXPECT_NEAR(hit->normal.z, -1.0, 1e-12);
        EXPECT_FALSE(hitOf(SkinHull(hull, 0.001), {0.0, -0.21}));
    }
}

TEST(SkinPolygon, withoutAnAreaIsNoNaN)
{
    EXPECT_FALSE(hitOf(SkinPolygon({{0.1, 0.1}, {0.1, 0.1}, {0.1, 0.1}}, 0.001), {0.1, 0.1}));
    const SkinPolygon doubled({{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, 0.001);
    const auto hit = hitOf(doubled, {0.5, 0.01});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->depth, 0.011, 1e-12);
}

/// Expects the robot upright on the ground, which carries its whole weight.
void expectAtRest(const RestPose& rest, const std::string& what)
{
    double upward = 0.0;
    for (const GroundContact& c : rest.contacts) upward += c.force.z;
    EXPECT_NEAR(upward, robot().totalMass() * 9.81, 1.0) << what;
    EXPECT_LT(std::abs(rest.pose.pitch), 1.2) << what;
    ASSERT_TRUE(std::isfinite(rest.energy) && std::isfinite(rest.pose.base.z)) << what;
    const Proprioception s = exactReadings(robot(), rest);
    for (const double number : {s.pitch, s.front, s.rear, *s.frontCurrent, *s.rearCurrent})
        EXPECT_TRUE(std::isfinite(number)) << what;
    for (const auto& force : s.force) EXPECT_TRUE(force && std::isfinite(*force)) << what;
}

TEST(RestPose, isFoundOrRefusedForExtremeFlippers)
{
    int rests = 0, folded = 0, others = 0;
    for (const TerrainProfile& ground : {flatTerrain(6.0), stepTerrain(0.2, 3.0, 6.0)})
        for (const double front : {-180.0, -90.0, 0.0, 90.0, 180.0})
            for (const double rear : {-180.0, -90.0, 0.0, 90.0, 180.0}) {
                const std::string what =
                    "front " + std::to_string(front) + ", rear " + std::to_string(rear);
                const auto rest = restPose(robot(), ground, 2.6, HoldAngle{front * kDegree},
                                           HoldAngle{rear * kDegree});
                if (rest) {
                    ++rests;
                    EXPECT_LE(std::max(std::abs(front), std::abs(rear)), 90.0) << what;
                    expectAtRest(*rest, what);
                } else if (rest.error().text.find("lies on the robot") != std::string::npos) {
                    ++folded;
                    EXPECT_EQ(std::max(std::abs(front), std::abs(rear)), 180.0) << what;
                } else {
                    ++others;
                    EXPECT_EQ(rest.error().text.find("no rest pose: "), 0U) << what;
                }
            }
    std::cout << rests << " rests, " << folded << " folded, " << others << " others refused\n";
    EXPECT_EQ(rests + folded + others, 50);
    EXPECT_GE(rests, 8);  // level or upright flippers carry the robot
    EXPECT_GE(folded, 8);
}

TEST(RestPose, steepStartEqualsALevelStartOrIsRefused)
{
    int rests = 0;
    const HoldAngle level{0.0};
    const auto expected = restPose(robot(), flatTerrain(6.0), 3.0, level, level);
    ASSERT_TRUE(expected);
    for (const double start : {-180.0, -90.0, -89.0, -45.0, 45.0, 89.0, 90.0, 180.0}) {
        const auto rest = restPose(robot(), flatTerrain(6.0), 3.0, level, level, start * kDegree);
        if (!rest) {
            EXPECT_EQ(rest.error().text.find("no rest pose: "), 0U) << start;
            continue;
        }
        ++rests;
        expectAtRest(*rest, std::to_string(start));
        EXPECT_NEAR(rest->pose.pitch, expected->pose.pitch, 1e-3) << start;
        EXPECT_NEAR(rest->pose.base.z, expected->pose.base.z, 1e-3) << start;
    }
    std::cout << rests << " rests\n";
    EXPECT_GE(rests, 2);
}

TEST(RestPose, atATenMetreCliffIsARestOrAFall)
{
    for (const double height : {-10.0, 10.0}) {
        const TerrainProfile cliff = stepTerrain(height, 3.0, 6.0);
        int rests = 0;
        for (double x = 2.0; x < 4.0; x += 0.1) {
            const auto rest = restPose(robot(), cliff, x, PressTorque{18.0}, HoldAngle{0.2});
            if (!rest) {
                EXPECT_NE(rest.error().text.find("no rest pose"), std::string::npos);
                continue;
            }
            ++rests;
            EXPECT_TRUE(std::isfinite(rest->energy)) << x;
            EXPECT_TRUE(std::isfinite(rest->pose.base.z) && std::isfinite(rest->pose.pitch)) << x;
            const Heights truth = binHeights(cliff, imuPosition(robot(), rest->pose));
            for (const double h : truth) EXPECT_LE(std::abs(h), 11.0) << x;
        }
        EXPECT_GE(rests, 5) << height;
    }
}

TEST(RestPose, ofWhatIsNotANumberIsRefused)
{
    const TerrainProfile flat = flatTerrain(5.0);
    const HoldAngle level{0.0};
    for (const double bad : {std::nan(""), kInfinity}) {
        EXPECT_THROW((void)restPose(robot(), flat, bad, level, level), std::invalid_argument);
        EXPECT_THROW((void)restPose(robot(), flat, 1.0, HoldAngle{bad}, level),
                     std::invalid_argument);
        EXPECT_THROW((void)restPose(robot(), flat, 1.0, level, PressTorque{bad}),
                     std::invalid_argument);
        EXPECT_THROW((void)restPose(robot(), flat, 1.0, level, PressTorque{1.0, bad}),
                     std::invalid_argument);
    }
}

std::vector<double> wavyHeights(std::size_t count)
{
    std::vector<double> heights(count);
    for (std::size_t i = 0; i < count; ++i)
        heights[i] = 0.05 * std::sin(0.001 * static_cast<double>(i)) + (i % 1000 == 0 ? 10.0 : 0.0);
    return heights;
}

TEST(TerrainProfile, isExactFor100000Samples)
{
    const std::vector<double> heights = wavyHeights(100000);
    const TerrainProfile line = TerrainProfile::fromSamples(heights, 0.01, false);
    EXPECT_EQ(line.heightAt(500.0), heights[50000]);
    double area = 0.0;
    for (std::size_t i = 1; i < heights.size(); ++i) area += 0.005 * (heights[i - 1] + heights[i]);
    EXPECT_NEAR(line.meanOver(0.0, line.end()), area / line.end(), 1e-9);
    const TerrainProfile blocks = TerrainProfile::fromSamples(heights, 0.01, true);
    EXPECT_EQ(blocks.heightAt(500.0), heights[50000]);
    EXPECT_EQ(sum(line, blocks).points().size(), line.points().size() + blocks.points().size());
    const auto rest = restPose(robot(), line, 505.0, PressTorque{18.0}, HoldAngle{0.2});
    ASSERT_TRUE(rest) << rest.error().text;  // between two peaks of 10 m
    EXPECT_TRUE(std::isfinite(rest->energy));
    EXPECT_NEAR(rest->pose.pitch, std::atan(0.005 * std::cos(50.5)), 0.01);
}

TEST(RestPose, isFoundOn100000SamplesUnderTheRobot)
{
    std::vector<double> heights(100000);
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = 0.01 * std::sin(1e-3 * static_cast<double>(i));
    const TerrainProfile dense = TerrainProfile::fromSamples(heights, 2e-5, false);
    const auto rest = restPose(robot(), dense, 1.0, HoldAngle{0.2}, HoldAngle{0.2});
    ASSERT_TRUE(rest) << rest.error().text;
    EXPECT_TRUE(std::isfinite(rest->energy));
    EXPECT_LT(std::abs(rest->pose.pitch), 0.3);
}

TEST(TerrainProfile, refusesGroundThatNoRobotCanStandOn)
{
    for (const double bad : {std::nan(""), kInfinity, -kInfinity, 1e300, -1.1e6}) {
        EXPECT_THROW(TerrainProfile({{0.0, bad}}), std::invalid_argument) << bad;
        EXPECT_THROW(TerrainProfile({{bad, 0.0}}), std::invalid_argument) << bad;
    }
    const TerrainProfile cliff({{0.0, -1e6}, {0.0, 1e6}});
    EXPECT_EQ(cliff.heightAt(0.0), 1e6);
    EXPECT_THROW((void)cliff.sampled(-1.0, 1.0, 0.005), std::invalid_argument);
    EXPECT_THROW((void)cliff.sampled(-1.0, 1.0, 1e-300), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
