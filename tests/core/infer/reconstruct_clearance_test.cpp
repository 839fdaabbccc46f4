#include "core/infer/reconstruct_clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/infer/estimate/quantile.h"
#include "core/infer/sampling/clearance_states.h"
#include "tests/support/infinity.h"
#include "tests/support/toy_clearance.h"

namespace terratact {
namespace {

Settings clearanceSettings(int draws = 400)
{
    Settings settings;
    settings.method = Method::Clearance;
    settings.draws = draws;
    settings.chains = 8;
    settings.forceThreshold = 1000.0;  // no contacts
    settings.hazardRate = 0.0;         // the method's own bands
    return settings;
}

TerrainEstimate reconstructClearance(const Proprioception& s, std::span<const ArmReading> arm,
                                     const RobotModel& robot, const ClearanceConditionals& models,
                                     const Settings& settings)
{
    return sampleScene(clearanceSampling(s, arm, robot, models, settings));
}

// ---- simulated scenes

struct ClearanceBench {
    RobotModel robot = absolem();
    ClearanceTraining training = campaignTraining();
    ClearanceConditionals models{training, plausibleConditionals(training)};
    std::vector<Scene> scenes = someScenes(3, 42, SensorNoise::none());
};

const ClearanceBench& clearanceBench()
{
    static const ClearanceBench shared;
    return shared;
}

bool isTrained(const Scene& scene)
{
    const Heights ceiling =
        bodyCeiling(clearanceBench().robot, scene.s.pitch, scene.s.front, scene.s.rear);
    for (int i = 0; i < kBins; ++i)
        if (clearanceBench()
                .models.data()
                .at(i, regimeOf(ceiling[static_cast<std::size_t>(i)]))
                .rows
            < kMinTrainingRows)
            return false;
    return true;
}

const Scene& trainedScene()
{
    return *std::find_if(clearanceBench().scenes.begin(), clearanceBench().scenes.end(), isTrained);
}

TEST(ReconstructClearance, keepsEveryDrawBelowItsCeiling)
{
    int scenes = 0;
    for (const Scene& scene : clearanceBench().scenes) {
        if (!isTrained(scene)) continue;
        ++scenes;
        const TerrainEstimate e = reconstructClearance(
            scene.s, {}, clearanceBench().robot, clearanceBench().models, clearanceSettings());
        ASSERT_EQ(e.draws.size(), 400U);
        for (std::size_t i = 0; i < kBins; ++i) {
            for (const Heights& h : e.draws) ASSERT_LE(h[i], e.ceiling[i]);
            EXPECT_LE(e.q10[i], e.height[i]);
            EXPECT_LE(e.height[i], e.q90[i]);
            EXPECT_TRUE(std::isfinite(e.mean[i]) && std::isfinite(e.rhat[i])
                        && std::isfinite(e.ess[i]));
        }
    }
    EXPECT_GE(scenes, 10);
}

TEST(ReconstructClearance, factorisesEveryBinInTheRegimeOfTheSceneAlone)
{
    const ClearanceConditionals models(clearanceBench().training,
                                       plausibleConditionals(clearanceBench().training));
    for (const Regime regime : kRegimes) EXPECT_EQ(models.factorised(regime), BinSet{});
    const TerrainEstimate e = reconstructClearance(trainedScene().s, {}, clearanceBench().robot,
                                                   models, clearanceSettings());
    BinSet covered;
    for (std::size_t i = 0; i < kBins; ++i)
        covered.set(i, regimeOf(e.ceiling[i]) == Regime::Covered);
    EXPECT_TRUE(covered.any() && !covered.all());
    EXPECT_EQ(models.factorised(Regime::Covered), covered);
    EXPECT_EQ(models.factorised(Regime::Open), ~covered);
}

TEST(ReconstructClearance, findsTheGroundUnderTheRobot)
{
    std::vector<double> errors;
    for (const Scene& scene : clearanceBench().scenes) {
        if (!isTrained(scene)) continue;
        const TerrainEstimate e = reconstructClearance(
            scene.s, {}, clearanceBench().robot, clearanceBench().models, clearanceSettings());
        for (std::size_t i = 0; i < kBins; ++i)
            if (!std::isinf(e.ceiling[i]))
                errors.push_back(std::abs(e.height[i] - *scene.truth[i]));
    }
    EXPECT_LT(quantile(errors, 0.5), 0.02);
}

TEST(ReconstructClearance, showsTheMedianOfItsDraws)
{
    const TerrainEstimate e = reconstructClearance(trainedScene().s, {}, clearanceBench().robot,
                                                   clearanceBench().models, clearanceSettings());
    for (std::size_t i = 0; i < kBins; ++i) {
        std::vector<double> heights;
        for (const Heights& h : e.draws) heights.push_back(h[i]);
        EXPECT_DOUBLE_EQ(e.height[i], quantile(heights, 0.5));
        EXPECT_DOUBLE_EQ(e.q10[i], quantile(heights, 0.1));
    }
}

TEST(ReconstructClearance, repeatsBitForBit)
{
    const auto run = [](std::uint64_t seed) {
        Settings settings = clearanceSettings();
        settings.seed = seed;
        return reconstructClearance(trainedScene().s, {}, clearanceBench().robot,
                                    clearanceBench().models, settings);
    };
    EXPECT_EQ(run(1), run(1));
    EXPECT_NE(run(1).draws, run(2).draws);
}

TEST(ReconstructClearance, throughInducingRowsComesCloseToTheTrainedModels)
{
    const auto through = [](int inducing) {
        Settings settings = clearanceSettings();
        settings.inducing = inducing;
        return reconstructClearance(trainedScene().s, {}, clearanceBench().robot,
                                    clearanceBench().models, settings);
    };
    const TerrainEstimate exact = through(0);
    const TerrainEstimate sparse = through(60);
    EXPECT_NE(exact.mean, sparse.mean);
    for (std::size_t i = 0; i < kBins; ++i)
        EXPECT_NEAR(sparse.height[i], exact.height[i], exact.sd[i]) << i;
    EXPECT_THROW((void)through(-1), std::invalid_argument);
}

TEST(ReconstructClearance, takesAContactAsAMeasurement)
{
    Proprioception s = trainedScene().s;
    s.force = {0.0, 0.0, 0.0, 0.0, 9.0, 0.0};
    Settings settings = clearanceSettings();
    settings.forceThreshold = 2.0;
    const TerrainEstimate e =
        reconstructClearance(s, {}, clearanceBench().robot, clearanceBench().models, settings);
    EXPECT_EQ(std::count(e.origin.begin(), e.origin.end(), Origin::Contact), 1);
    EXPECT_EQ(std::count(e.origin.begin(), e.origin.end(), Origin::Sampled), kBins - 1);
}

TEST(ReconstructClearance, keepsAnExactReadingAndDrawsTheOthers)
{
    const ClearanceConditionals models(clearanceBench().training,
                                       plausibleConditionals(clearanceBench().training));
    const ArmReading reading{10, -0.2, kExactSd};
    const TerrainEstimate e = reconstructClearance(
        trainedScene().s, {&reading, 1}, clearanceBench().robot, models, clearanceSettings());
    EXPECT_EQ(e.origin[10], Origin::Arm);
    EXPECT_EQ(e.height[10], -0.2);
    EXPECT_EQ(e.sd[10], kExactSd);
    for (const Heights& h : e.draws) EXPECT_EQ(h[10], -0.2);
    const BinSet factorised = models.factorised(Regime::Covered) | models.factorised(Regime::Open);
    EXPECT_EQ(factorised, ~BinSet(1U << 10U));
}

TEST(ReconstructClearance, samplesNothingWhereEveryReadingIsExact)
{
    const ClearanceConditionals models(clearanceBench().training,
                                       plausibleConditionals(clearanceBench().training));
    std::vector<ArmReading> arm;
    for (int bin = 0; bin < kBins; ++bin) arm.push_back({bin, 0.5, kExactSd});
    const TerrainEstimate e = reconstructClearance(trainedScene().s, arm, clearanceBench().robot,
                                                   models, clearanceSettings());
    EXPECT_EQ(e.ending, Ending::NotSampled);
    EXPECT_TRUE(e.converged);
    for (const Regime regime : kRegimes) EXPECT_EQ(models.factorised(regime), BinSet{});
    for (std::size_t i = 0; i < kBins; ++i) {
        EXPECT_EQ(e.height[i], std::min(0.5, e.ceiling[i]));  // never above the robot's edge
        EXPECT_LE(e.q90[i], e.ceiling[i]);
    }
}

// ---- a world whose posterior is known

struct KnownWorld {
    RobotModel robot = absolem();
    ClearanceTraining training = knownWorldTraining(250, 11);
    ClearanceConditionals models{training, trained(training)};
    Proprioception s;

    KnownWorld()
    {
        s.pitch = 0.02;
        s.front = 0.05;
        s.rear = 0.1;
        s.frontCurrent = s.rearCurrent = 0.8;
        s.force.fill(0.8);
    }

    static ClearanceConditionalData trained(const ClearanceTraining& training)
    {
        ClearanceConditionalData data = prepareClearanceConditionals(training);
        TrainingOptions options;
        options.fullEvaluations = 30;
        for (int i = 0; i < kBins; ++i)
            for (const Regime regime : kRegimes)
                if (data.at(i, regime).rows >= kMinTrainingRows)
                    data.at(i, regime).hyper =
                        trainClearanceConditional(training, data, i, regime, options).hyper;
        return data;
    }
};

const KnownWorld& world()
{
    static const KnownWorld shared;
    return shared;
}

/// Returns the world's z of one bin's draws.
Eigen::VectorXd zOf(const TerrainEstimate& e, std::size_t bin)
{
    Eigen::VectorXd z(static_cast<Eigen::Index>(e.draws.size()));
    for (std::size_t d = 0; d < e.draws.size(); ++d) {
        const double y = toLogClearance(e.draws[d][bin], e.ceiling[bin]);
        z[static_cast<Eigen::Index>(d)] =
            regimeOf(e.ceiling[bin]) == Regime::Open ? (y + 0.2) / 0.05 : (y + 4.0) / 0.6;
    }
    return z;
}

double sdOf(const Eigen::VectorXd& z)
{
    return std::sqrt((z.array() - z.mean()).square().mean());
}

TerrainEstimate inKnownWorld(std::span<const ArmReading> arm = {})
{
    Settings settings = clearanceSettings(16000);
    settings.chains = 10;
    return reconstructClearance(world().s, arm, world().robot, world().models, settings);
}

const TerrainEstimate& untouchedWorld()
{
    static const TerrainEstimate shared = inKnownWorld();
    return shared;
}

TEST(ReconstructClearance, agreesWithAKnownJointDistribution)
{
    const TerrainEstimate& e = untouchedWorld();
    EXPECT_TRUE(e.converged);
    for (std::size_t i = 0; i < kBins; ++i) {
        const Eigen::VectorXd z = zOf(e, i);
        EXPECT_NEAR(z.mean(), 0.0, 0.35) << i;
        EXPECT_NEAR(sdOf(z), 1.0, 0.25) << i;
        if (i == 0) continue;
        const Eigen::VectorXd before = zOf(e, i - 1);
        const double covariance =
            ((z.array() - z.mean()) * (before.array() - before.mean())).mean();
        EXPECT_NEAR(covariance / (sdOf(z) * sdOf(before)), kToyCorrelation, 0.25) << i;
    }
}

TEST(ReconstructClearance, weighsAnArmReadingAgainstTheModel)
{
    // z of an open bin: N(0, 1) times a reading of z = 2 with sd 0.03 / 0.05 = 0.6.
    const ArmReading reading{10, -0.1, 0.03};
    const TerrainEstimate e = inKnownWorld({&reading, 1});
    ASSERT_TRUE(std::isinf(e.ceiling[10]));
    EXPECT_EQ(e.origin[10], Origin::Arm);
    const double share = 1.0 / (1.0 + 0.36);
    EXPECT_NEAR(zOf(e, 10).mean(), 2.0 * share, 0.25);
    EXPECT_NEAR(sdOf(zOf(e, 10)), 0.6 * std::sqrt(share), 0.1);
    EXPECT_NEAR(zOf(e, 9).mean() - zOf(untouchedWorld(), 9).mean(), kToyCorrelation * 2.0 * share,
                0.35);
}

TEST(MeasuredState, isExactInTheOpenAndLinearisedUnderTheRobot)
{
    const Normal open = measuredState(-0.1, 0.03, kInfinity);
    EXPECT_DOUBLE_EQ(open.mean, -0.1);
    EXPECT_DOUBLE_EQ(open.variance, 0.0009);
    const Normal covered = measuredState(-0.297, 0.02, -0.2);
    EXPECT_NEAR(covered.mean, std::log(0.1), 1e-12);
    EXPECT_NEAR(std::sqrt(covered.variance), 0.2, 1e-12);
    const Normal above = measuredState(-0.1, 0.02, -0.2);
    EXPECT_DOUBLE_EQ(above.mean, std::log(kClearanceOffset));
    EXPECT_DOUBLE_EQ(std::sqrt(above.variance), 0.02 / kClearanceOffset);
    EXPECT_THROW((void)measuredState(0.0, 0.0, -0.2), std::invalid_argument);
    EXPECT_THROW((void)measuredState(kInfinity, 0.1, -0.2), std::invalid_argument);
}

// ---- refusals

TEST(ReconstructClearance, refusesOtherMethodsAndUntrainedRegimes)
{
    const auto run = [](Settings settings, Proprioception s, std::span<const ArmReading> arm,
                        const ClearanceConditionals& models) {
        return reconstructClearance(s, arm, world().robot, models, settings);
    };
    const Settings good = clearanceSettings(8);
    EXPECT_NO_THROW((void)run(good, world().s, {}, world().models));
    Settings other = good;
    other.method = Method::Pafc;
    EXPECT_THROW((void)run(other, world().s, {}, world().models), std::invalid_argument);
    Settings none = good;
    none.chains = 0;
    EXPECT_THROW((void)run(none, world().s, {}, world().models), std::invalid_argument);
    Proprioception forceless = world().s;
    forceless.force[2].reset();
    EXPECT_THROW((void)run(good, forceless, {}, world().models), std::invalid_argument);
    const ArmReading nowhere{11, -0.1, 0.03};
    EXPECT_THROW((void)run(good, world().s, {&nowhere, 1}, world().models), std::invalid_argument);

    ClearanceTraining open = world().training;  // never under the robot
    open.ceilings.setConstant(kInfinity);
    const ClearanceConditionals never(open, plausibleConditionals(open));
    EXPECT_THROW((void)run(good, world().s, {}, never), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
