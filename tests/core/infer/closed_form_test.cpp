#include "core/infer/closed_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/infer/estimate/quantile.h"
#include "core/infer/estimator.h"
#include "core/infer/verdict/obstacle.h"
#include "core/learn/model/clearance.h"
#include "core/terrain/body_ceiling.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

struct Bench {
    RobotModel robot = absolem();
    ModelData data = toyModel(60);
    Models models{data, robot};
    std::vector<Scene> scenes = someScenes(20, 77, [] {
        SensorNoise noise;
        noise.height = 0.0;
        return noise;
    }());
};

const Bench& bench()
{
    static const Bench instance;
    return instance;
}

Settings settingsFor(Method method)
{
    Settings settings;
    settings.method = method;
    return settings;
}

TerrainEstimate estimate(const Scene& scene, Method method, std::span<const ArmReading> arm = {})
{
    return estimateTerrain(scene.s, arm, bench().robot, bench().models, settingsFor(method));
}

TEST(ClosedForm, noHeightIsDeeperInTheBodyThanSinking)
{
    for (const Method method : {Method::Joint, Method::Local})
        for (const Scene& scene : bench().scenes) {
            const TerrainEstimate e = estimate(scene, method);
            for (std::size_t i = 0; i < kBins; ++i) {
                const double most = e.ceiling[i] + kDeepestSinking;
                EXPECT_LE(e.q90[i], most);
                EXPECT_LE(e.mean[i], most);
                EXPECT_LE(e.q10[i], e.height[i]);
                EXPECT_LE(e.height[i], e.q90[i]);
                EXPECT_GT(e.sd[i], 0.0);
                for (const Heights& draw : e.draws) EXPECT_LE(draw[i], most);
            }
        }
}

TEST(ClosedForm, factorisesNoConditional)
{
    const Models models(bench().data, bench().robot);
    for (const Method method : {Method::Joint, Method::Local})
        estimateTerrain(bench().scenes[0].s, {}, bench().robot, models, settingsFor(method));
    EXPECT_EQ(models.pa.factorised(), BinSet{});
    EXPECT_EQ(models.paf.factorised(), BinSet{});
    for (const Regime regime : kRegimes)
        EXPECT_EQ(models.conditionals.factorised(regime), BinSet{});
}

TEST(ClosedForm, agreesWithItsOwnDraws)
{
    for (const Method method : {Method::Joint, Method::Local})
        for (std::size_t k = 0; k < 5; ++k) {
            Settings settings = settingsFor(method);
            settings.draws = 40000;
            settings.stopEarly = false;
            settings.hazardRate = 0.0;
            const ArmReading probe{10, -0.1, 0.03};
            const TerrainEstimate e = estimateTerrain(bench().scenes[k * 7].s, {&probe, 1},
                                                      bench().robot, bench().models, settings);
            for (std::size_t i = 0; i < kBins; ++i) {
                std::vector<double> draws;
                for (const Heights& draw : e.draws) draws.push_back(draw[i]);
                const double width = e.q90[i] - e.q10[i] + 1e-4;
                EXPECT_NEAR(quantile(draws, 0.1), e.q10[i], 0.05 * width) << i;
                EXPECT_NEAR(quantile(draws, 0.5), e.height[i], 0.05 * width) << i;
                EXPECT_NEAR(quantile(draws, 0.9), e.q90[i], 0.05 * width) << i;
            }
        }
}

TEST(ClosedForm, stopEarlyDrawsOnlyEnoughDraws)
{
    for (const Method method : {Method::Joint, Method::Local})
        for (const bool early : {true, false})
            for (const int draws : {kEnoughDraws - 1, kEnoughDraws + 1}) {
                Settings settings = settingsFor(method);
                settings.draws = draws;
                settings.stopEarly = early;
                const TerrainEstimate e = estimateTerrain(bench().scenes.front().s, {},
                                                          bench().robot, bench().models, settings);
                const int expected = early ? std::min(draws, kEnoughDraws) : draws;
                EXPECT_EQ(e.draws.size(), static_cast<std::size_t>(expected));
                EXPECT_EQ(e.ess[0], expected);
            }
}

TEST(ClosedForm, keepsTheSamplesMeanAndCovarianceWhenItSmooths)
{
    const Scene& scene = bench().scenes.front();
    const Eigen::VectorXd x = features(FeatureSet::Paf, scene.s);
    const unsigned covered =
        coveredBins(bodyCeiling(bench().robot, scene.s.pitch, scene.s.front, scene.s.rear));
    const ClearanceModel& model = bench().models.clearance;
    const ResidualSample sample = model.localResiduals(x, covered);
    const Eigen::VectorXd middle = sample.residual * sample.weight;
    const Eigen::MatrixXd spread = sample.residual.colwise() - middle;
    const Eigen::MatrixXd expected = spread * sample.weight.asDiagonal() * spread.transpose();

    const GaussianMixture m = surfaceDistribution(model, x, covered, Method::Local);
    const Eigen::VectorXd mean = m.mean * m.weight;
    const Eigen::MatrixXd centred = m.mean.colwise() - mean;
    const Eigen::MatrixXd covariance =
        centred * m.weight.asDiagonal() * centred.transpose() + m.covariance;
    EXPECT_TRUE(covariance.isApprox(expected, 1e-9));
    const Heights centre = model.predict(x, covered);
    for (int i = 0; i < kBins; ++i)
        EXPECT_NEAR(mean[i], centre[static_cast<std::size_t>(i)] + middle[i], 1e-9);
}

TEST(ClosedForm, aProbePullsItsBinAndNarrowsIt)
{
    for (const Method method : {Method::Joint, Method::Local})
        for (std::size_t k = 0; k < bench().scenes.size(); k += 9) {
            const Scene& scene = bench().scenes[k];
            const TerrainEstimate before = estimate(scene, method);
            if (before.sd[9] < 0.05) continue;
            const ArmReading probe{9, *scene.truth[9], 0.03};
            const TerrainEstimate after = estimate(scene, method, {&probe, 1});
            EXPECT_EQ(after.origin[9], Origin::Arm);
            EXPECT_LT(after.sd[9], 0.5 * before.sd[9]);
            EXPECT_NEAR(after.height[9], *scene.truth[9], 0.09);
        }
}

TEST(ClosedForm, anArmThatFindsAHoleIsBelieved)
{
    for (const Method method : {Method::Joint, Method::Local})
        for (std::size_t k = 0; k < 5; ++k) {
            const Scene& scene = bench().scenes[k * 7];
            const TerrainEstimate before = estimate(scene, method);
            const ArmReading hole{10, before.height[10] - 0.7, 0.03};
            const TerrainEstimate e = estimate(scene, method, {&hole, 1});
            EXPECT_NEAR(e.height[10], hole.height, 0.03);
            EXPECT_NEAR(e.height[8], before.height[8], 0.05) << "the hole explains the reading";
            EXPECT_GT(anyStep(e, 0.1, kFirstAhead).p, 0.99);
        }
}

TEST(ClosedForm, contradictingProbesGiveNoGroundBeyondReason)
{
    // Readings that no scene of training explains lead to coordinates whose sinh is kilometres.
    std::vector<ArmReading> arm;
    for (const int bin : {2, 4, 6, 8, 10})
        arm.insert(arm.end(), {.bin = bin, .height = bin % 4 == 0 ? -2.2 : -0.24, .sd = 0.01});
    for (const Method method : {Method::Joint, Method::Local})
        for (const Scene& scene : bench().scenes) {
            Settings settings = settingsFor(method);
            settings.hazardRate = 0.0;  // hazards lie deeper
            const TerrainEstimate e =
                estimateTerrain(scene.s, arm, bench().robot, bench().models, settings);
            for (std::size_t i = 0; i < kBins; ++i) {
                if (std::isinf(e.ceiling[i])) continue;
                const double lowest = e.ceiling[i] - kDeepestSurface;
                EXPECT_GE(e.mean[i], lowest - 1e-9);
                EXPECT_GE(e.q10[i], lowest - 1e-9);
                EXPECT_LE(e.sd[i], kDeepestSurface);
                for (const Heights& draw : e.draws) ASSERT_GE(draw[i], lowest - 1e-9);
            }
        }
}

TEST(ClosedForm, flagsAProbeInsideTheRobotAndASceneUnlikeTraining)
{
    const Scene& scene = bench().scenes.front();
    const ArmReading inside{3, 0.3, 0.03};
    const TerrainEstimate e = estimate(scene, Method::Local, {&inside, 1});
    EXPECT_TRUE(std::any_of(e.warnings.begin(), e.warnings.end(), [](const Message& w) {
        return w.english().find("above the robot's own lower edge") != std::string::npos;
    }));
    EXPECT_LE(e.height[3], e.ceiling[3] + kDeepestSinking);

    Scene strange = scene;
    strange.s.force.fill(400.0);
    strange.s.pitch = -0.9;
    const TerrainEstimate unlike = estimate(strange, Method::Local);
    EXPECT_GT(unlike.novelty, 1.0);
    EXPECT_TRUE(std::any_of(unlike.warnings.begin(), unlike.warnings.end(), [](const Message& w) {
        return w.english().find("unlike the training scenes") != std::string::npos;
    }));
}

TEST(ClosedForm, coversMostTruthsOfOtherDrives)
{
    // This is a toy model; `terratact evaluate` judges the shipped one.
    int inside = 0;
    int all = 0;
    for (const Scene& scene : bench().scenes) {
        const TerrainEstimate e = estimate(scene, Method::Local);
        for (std::size_t i = 0; i < kBins; ++i) {
            ++all;
            inside += e.q10[i] <= *scene.truth[i] && *scene.truth[i] <= e.q90[i] ? 1 : 0;
        }
    }
    EXPECT_GT(static_cast<double>(inside) / all, 0.6);
    EXPECT_LT(static_cast<double>(inside) / all, 0.95);
}

TEST(ClosedForm, repeatsForASeedAndRefusesWrongArguments)
{
    const Scene& scene = bench().scenes.front();
    EXPECT_EQ(estimate(scene, Method::Local), estimate(scene, Method::Local));
    const ClearanceModel& model = bench().models.clearance;
    EXPECT_THROW(
        (void)reconstructClosedForm(scene.s, {}, bench().robot, model, settingsFor(Method::Pafc)),
        std::invalid_argument);
    const ArmReading wrong{11, 0.0, 0.03};
    EXPECT_THROW((void)estimate(scene, Method::Local, {&wrong, 1}), std::invalid_argument);
    Proprioception lacking = scene.s;
    lacking.force[2].reset();
    EXPECT_THROW(
        (void)reconstructClosedForm(lacking, {}, bench().robot, model, settingsFor(Method::Local)),
        std::invalid_argument);
}

TEST(Surface, goesBackAndForth)
{
    for (const double h : {-0.5, -0.3, -0.2501, -0.24})
        EXPECT_NEAR(toHeight(toSurface(h, -0.25), -0.25), h, 1e-12);
    EXPECT_NEAR(toHeight(toSurface(-0.2, -0.25), -0.25), -0.25 + kDeepestSinking, 1e-12);
    EXPECT_EQ(toHeight(-50.0, -0.25), -0.25 + kDeepestSinking);
    EXPECT_EQ(toHeight(50.0, -0.25), -0.25 - kDeepestSurface);
    EXPECT_EQ(toHeight(1000.0, -0.25), -0.25 - kDeepestSurface) << "sinh overflows";
    const double open = std::numeric_limits<double>::infinity();
    EXPECT_EQ(toHeight(toSurface(0.1, open), open), 0.1);
}

}  // namespace
}  // namespace terratact
