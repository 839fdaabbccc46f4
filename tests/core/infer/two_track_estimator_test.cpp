#include "core/infer/two_track_estimator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/infer/closed_form.h"
#include "core/infer/each_side.h"
#include "core/infer/reconstruct.h"
#include "core/learn/model/file/model_file.h"
#include "tests/support/toy_model.h"
#include "tests/support/toy_sides.h"

namespace terratact {
namespace {

/// Models that differ in the part of two tracks only.
const Models& models(bool tracks)
{
    static const ModelData plane = [] {
        ModelData model = toyModel(12);
        model.sides = {};
        return model;
    }();
    static const ModelData both = [] {
        ModelData model = plane;
        model.sides = toySides(16);
        return model;
    }();
    static const Models ofPlane(plane, absolem()), ofBoth(both, absolem());
    return tracks ? ofBoth : ofPlane;
}

const std::vector<TwoTrackScene>& scenes()
{
    static const std::vector<TwoTrackScene> some = someTrackScenes(4, 9);
    return some;
}

TwoTrackEstimate estimateOf(const TwoTrackReadings& s, const SideArms& arms = {})
{
    return estimateByBothSides(s, arms, absolem(), models(true), {.hazardRate = 0.0});
}

/// Returns the first scene that has rolled.
const TwoTrackScene& rolled()
{
    return *std::ranges::find_if(scenes(),
                                 [](const auto& scene) { return std::abs(scene.s.roll) > 0.08; });
}

TEST(TwoTrackEstimator, mirroredReadingsGiveTheMirroredGround)
{
    for (std::size_t k = 0; k < 6; ++k) {
        const TwoTrackEstimate own = estimateOf(scenes()[k].s);
        const TwoTrackEstimate mirror = estimateOf(mirrored(scenes()[k].s));
        for (std::size_t i = 0; i < kBins; ++i) {
            EXPECT_NEAR(own.side[0].height[i], mirror.side[1].height[i], 1e-6) << k << ' ' << i;
            EXPECT_NEAR(own.side[1].q90[i], mirror.side[0].q90[i], 1e-6) << k << ' ' << i;
        }
        EXPECT_NEAR(own.side[0].novelty, mirror.side[0].novelty, 1e-9);
    }
}

TEST(TwoTrackEstimator, theHigherSideIsHigher)
{
    const TwoTrackEstimate estimate = estimateOf(rolled().s);
    const double difference = estimate.side[0].height[3] - estimate.side[1].height[3];
    EXPECT_GT(difference * rolled().s.roll, 0.0);
    EXPECT_GT((estimate.side[0].ceiling[3] - estimate.side[1].ceiling[3]) * rolled().s.roll, 0.0);
}

TEST(TwoTrackEstimator, drawsAreJointAndHoldTheQuantiles)
{
    const TwoTrackEstimate estimate = estimateOf(rolled().s);
    ASSERT_EQ(estimate.side[0].draws.size(), estimate.side[1].draws.size());
    for (const TerrainEstimate& side : estimate.side) {
        std::size_t below = 0;
        for (const Heights& draw : side.draws) below += draw[3] < side.q10[3] ? 1 : 0;
        EXPECT_NEAR(static_cast<double>(below) / static_cast<double>(side.draws.size()), 0.1, 0.04);
    }
}

TEST(TwoTrackEstimator, anArmReadingMovesItsOwnSideMost)
{
    const TwoTrackReadings& s = rolled().s;
    const TwoTrackEstimate before = estimateOf(s);
    const std::vector<ArmReading> arm{
        {.bin = 10, .height = before.side[1].height[10] + 0.1, .sd = 0.01}};
    const TwoTrackEstimate after = estimateOf(s, {std::span<const ArmReading>{}, arm});
    const double moved = after.side[1].height[10] - before.side[1].height[10];
    EXPECT_GT(moved, 0.05);
    EXPECT_LT(std::abs(after.side[0].height[10] - before.side[0].height[10]), moved);
    EXPECT_EQ(after.side[1].origin[10], Origin::Arm);
    EXPECT_EQ(after.side[0].origin[10], Origin::Sampled);
    EXPECT_EQ(after.side[1].touch[10], Touch::FeltInPart);
    EXPECT_LT(after.side[1].sd[10], before.side[1].sd[10]);
}

TEST(TwoTrackEstimator, worksWithOneSidesArrayOnly)
{
    TwoTrackReadings s = rolled().s;
    s.forces[indexOf(Flipper::FrontRight)] = {};
    const TwoTrackEstimate estimate = estimateTwoTracks(s, {}, absolem(), models(true), {});
    EXPECT_FALSE(estimate.onePlane);
    EXPECT_TRUE(estimate.side[0].missing.none());
    EXPECT_EQ(estimate.side[1].missing.count(), 6U);
    EXPECT_NE(estimate.side[1].touch[6], Touch::Felt);
    s.forces = {};
    s.currents = {};
    const TwoTrackEstimate blind = estimateTwoTracks(s, {}, absolem(), models(true), {});
    EXPECT_EQ(blind.side[0].missing.count(), 8U);
}

TEST(TwoTrackEstimator, aSymmetricSceneIsOnePlane)
{
    TwoTrackReadings s = scenes().front().s;
    s.roll = 0.001;
    s.flippers = {0.2, 0.201, 0.1, 0.1};
    s.currents = {1.0, 1.0, 1.0, 1.0};
    s.forces[1] = s.forces[0];
    const TwoTrackEstimate estimate = estimateTwoTracks(s, {}, absolem(), models(true), {});
    EXPECT_TRUE(estimate.onePlane);
    EXPECT_EQ(estimate.side[0], estimate.side[1]);
    const std::vector<ArmReading> arm{{.bin = 9, .height = 0.0, .sd = 0.03}};
    EXPECT_FALSE(estimateTwoTracks(s, {arm, {}}, absolem(), models(true), {}).onePlane);
}

/// A line of telemetry with the readings of rolled(), both arrays known.
Measurement rolledLine()
{
    return measurementOf(rolled().s);
}

Measurement evenLine()
{
    TwoTrackReadings s = scenes().front().s;
    s.roll = 0.001;
    s.flippers = {0.2, 0.2, 0.1, 0.1};
    s.currents = {1.0, 1.0, 1.0, 1.0};
    s.forces[1] = s.forces[0];
    return measurementOf(s);
}

TwoTrackEstimate measured(const Measurement& line, std::span<const ArmReading> readings = {},
                          const Settings& settings = {}, bool tracks = true)
{
    return estimateMeasured(line, readings, absolem(), models(tracks), settings);
}

TwoTrackEstimate planeOf(const Measurement& line, std::span<const ArmReading> readings = {},
                         const Settings& settings = {})
{
    TerrainEstimate plane =
        estimateTerrain(proprioception(line), readings, absolem(), models(false), settings);
    warnIfNotPlanar(plane, line);
    return equalSides(plane);
}

std::string sentencesOf(const TwoTrackEstimate& estimate)
{
    return english(estimate.side[0].warnings, "; ");
}

TEST(EstimateMeasured, estimatesBothSidesOfAnUnevenScene)
{
    const TwoTrackEstimate estimate = measured(rolledLine());
    EXPECT_FALSE(estimate.onePlane);
    EXPECT_EQ(estimate,
              estimateByBothSides(twoTrackReadings(rolledLine()), {}, absolem(), models(true), {}));
    EXPECT_EQ(sentencesOf(estimate).find("not the same left and right"), std::string::npos);
}

TEST(EstimateMeasured, aSymmetricSceneIsTodaysPlane)
{
    EXPECT_EQ(measured(evenLine()), planeOf(evenLine()));
    const std::vector<ArmReading> middle{{.bin = 9, .height = 0.0, .sd = 0.03}};
    EXPECT_EQ(measured(evenLine(), middle), planeOf(evenLine(), middle));
    const std::vector<ArmReading> left{
        {.bin = 9, .height = 0.0, .sd = 0.03, .side = ProbeSide::Left}};
    const TwoTrackEstimate both = measured(evenLine(), left);
    EXPECT_FALSE(both.onePlane);
    EXPECT_EQ(both.side[0].origin[9], Origin::Arm);
    EXPECT_EQ(both.side[1].origin[9], Origin::Sampled);
}

TEST(EstimateMeasured, aModelOfOnePlaneStaysTodaysPlane)
{
    EXPECT_EQ(measured(rolledLine(), {}, {}, false), planeOf(rolledLine()));
    EXPECT_NE(sentencesOf(measured(rolledLine(), {}, {}, false)).find("roll"), std::string::npos);
}

TEST(EstimateMeasured, aSourceWithoutSidesStaysTodaysPlane)
{
    Measurement means = rolledLine();
    means.sides = {};
    EXPECT_FALSE(hasSides(means));
    EXPECT_EQ(measured(means), planeOf(means));
}

TEST(EstimateMeasured, warnsWhereOnlyOnePlaneIsPossible)
{
    const Settings paper{.method = Method::Pafc, .draws = 20};
    const TwoTrackEstimate sampled = measured(rolledLine(), {}, paper);
    EXPECT_TRUE(sampled.onePlane);
    EXPECT_NE(sentencesOf(sampled).find("method pafc estimates left and right as one plane"),
              std::string::npos);
    EXPECT_EQ(measured(evenLine(), {}, paper), planeOf(evenLine(), {}, paper));
    Measurement turned = rolledLine();
    turned.differential = 0.1;
    EXPECT_TRUE(measured(turned).onePlane);
    EXPECT_NE(sentencesOf(measured(turned)).find("the track differential has turned"),
              std::string::npos);
}

TEST(EstimateMeasured, aPlaneNamesTheSideThatLacksForces)
{
    const auto saysWithout = [](const SideForces& sides, const Settings& settings = {}) {
        Measurement line = evenLine();
        setSides(line, sides);
        const TwoTrackEstimate plane = measured(line, {}, settings, false);
        EXPECT_TRUE(plane.onePlane);
        EXPECT_TRUE(plane.side[0].missing.none()) << "the other side has them";
        return sentencesOf(plane);
    };
    SideForces sides = evenLine().sides;
    EXPECT_EQ(saysWithout(sides).find("for both"), std::string::npos);
    sides.right = {};
    const std::string rightArray =
        "right: no force was measured: the other side's forces count for both";
    EXPECT_NE(saysWithout(sides).find(rightArray), std::string::npos) << saysWithout(sides);
    EXPECT_NE(saysWithout(sides, {.method = Method::Pafc, .draws = 20}).find(rightArray),
              std::string::npos);
    EXPECT_EQ(saysWithout(sides, {.method = Method::Pac, .draws = 20}).find(rightArray),
              std::string::npos)
        << "it uses no forces";
    sides.right = sides.left;
    sides.left[2].reset();
    EXPECT_NE(saysWithout(sides).find("left: the force of element 3 was not measured: the other "
                                      "side's counts for both"),
              std::string::npos)
        << saysWithout(sides);
}

TEST(EstimateMeasured, clearanceEstimatesEachSideForItself)
{
    const auto shipped = readModel(TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
    ASSERT_TRUE(shipped);
    const Models trained(shipped->data, absolem());
    const Settings settings{.method = Method::Clearance, .draws = 20, .inducing = 40};
    EXPECT_TRUE(allowsBothSides(rolledLine(), Method::Clearance));
    EXPECT_EQ(estimateMeasured(rolledLine(), {}, absolem(), trained, settings),
              estimateEachSide(twoTrackReadings(rolledLine()), {}, absolem(), trained, settings));
    EXPECT_TRUE(estimateMeasured(evenLine(), {}, absolem(), trained, settings).onePlane);
}

/// rolledLine() without the current of the front left motor.
Measurement lineWithoutACurrent()
{
    TwoTrackReadings s = rolled().s;
    s.currents[indexOf(Flipper::FrontLeft)].reset();
    return measurementOf(s);
}

TEST(EstimateMeasured, aMissingCurrentIsOfItsSide)
{
    const TwoTrackEstimate estimate = measured(lineWithoutACurrent());
    EXPECT_FALSE(estimate.onePlane);
    EXPECT_TRUE(estimate.side[0].missing[kFrontCurrentFeature]);
    EXPECT_TRUE(estimate.side[1].missing.none());
    EXPECT_NE(sentencesOf(estimate).find("the front flippers' current was not measured"),
              std::string::npos);
}

TEST(EstimateMeasured, aPlaneCountsTheCurrentOfOneMotor)
{
    const Measurement line = lineWithoutACurrent();
    EXPECT_EQ(proprioception(line).frontCurrent, line.frontRightCurrent);
    const TwoTrackEstimate estimate = measured(line, {}, {}, false);
    EXPECT_TRUE(estimate.onePlane);
    EXPECT_TRUE(estimate.side[0].missing.none());
    EXPECT_NE(sentencesOf(estimate).find("the front left flipper current was not measured: the "
                                         "other side counts for both"),
              std::string::npos);
    EXPECT_EQ(sentencesOf(measured(rolledLine(), {}, {}, false)).find("was not measured"),
              std::string::npos);
}

TEST(EstimateMeasured, unmeasuredCurrentsMakeNoSidesDiffer)
{
    const Settings paper{.method = Method::Pafc, .draws = 20};
    Measurement line = evenLine();
    setCurrents(line, {std::nullopt, 1.0, 1.0, 1.0});
    const std::string even = sentencesOf(measured(line, {}, paper));
    EXPECT_EQ(even.find("although they differ"), std::string::npos) << even;
    EXPECT_NE(even.find("the front left flipper current was not measured"), std::string::npos);
    EXPECT_NE(sentencesOf(measured(lineWithoutACurrent(), {}, paper)).find("although they differ"),
              std::string::npos)
        << "they differ in what both have";
}

TEST(EstimateMeasured, aReadingBetweenTheSidesCountsForNeither)
{
    const std::vector<ArmReading> middle{{.bin = 9, .height = 0.0, .sd = 0.03}};
    const TwoTrackEstimate estimate = measured(rolledLine(), middle);
    EXPECT_EQ(estimate.side[0].origin[9], Origin::Sampled);
    EXPECT_NE(sentencesOf(estimate).find("+0.6 m lies in the middle"), std::string::npos);
}

TEST(TwoTrackEstimator, refusesWhatItHasNotLearnt)
{
    const TwoTrackReadings& s = rolled().s;
    EXPECT_THROW((void)estimateTwoTracks(s, {}, absolem(), models(false), {}), RefusedInput);
    TwoTrackReadings turned = s;
    turned.differential = 0.1;
    EXPECT_THROW((void)estimateTwoTracks(turned, {}, absolem(), models(true), {}), RefusedInput);
    EXPECT_THROW((void)estimateTwoTracks(s, {}, absolem(), models(true), {.method = Method::Pafc}),
                 std::invalid_argument);
    for (const Method method : {Method::Joint, Method::Local})
        EXPECT_NO_THROW(
            (void)estimateTwoTracks(s, {}, absolem(), models(true), {.method = method}));
}

}  // namespace
}  // namespace terratact
