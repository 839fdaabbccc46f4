// Extreme ceilings, settings and models: each estimate is right or refused with a text.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/infer/closed_form.h"
#include "core/infer/estimator.h"
#include "core/infer/sampling/convergence.h"
#include "core/infer/sampling/draw_summary.h"
#include "core/infer/sampling/gibbs.h"
#include "tests/core/infer/extreme_scenes.h"
#include "tests/support/random_model.h"

namespace terratact {
namespace {

GibbsProblem paperProblem(double ceiling, CeilingRule rule)
{
    GibbsProblem problem;
    problem.s = features(FeatureSet::Paf, someScene().s);
    problem.ceiling.fill(ceiling);
    problem.rule = rule;
    problem.chains = 4;
    problem.burnIn = 3;
    problem.keptPerChain = 25;
    return problem;
}

TEST(Estimate, modelOfOneTrainingRowGivesAnEstimate)
{
    const ClearanceModel one(randomModel(1));
    for (const Method method : {Method::Local, Method::Joint}) {
        Settings settings;
        settings.method = method;
        const auto numbers =
            numbersOf(reconstructClosedForm(someScene().s, {}, robot(), one, settings));
        EXPECT_TRUE(std::all_of(numbers.begin(), numbers.end(), [](double v) {
            return std::isfinite(v);
        })) << name(method);
    }
}

TEST(Estimate, aModelWhoseNumbersOverflowIsRefusedWithAText)
{
    ModelData model = randomModel(20);
    for (SurfaceProcess& process : model.clearance.covered) process.mean = 1e9;  // sinh: infinite
    const ClearanceModel wrong(model);
    for (const Method method : {Method::Local, Method::Joint}) {
        Settings settings;
        settings.method = method;
        EXPECT_THROW(
            static_cast<void>(reconstructClosedForm(someScene().s, {}, robot(), wrong, settings)),
            std::invalid_argument)
            << name(method);
    }
}

TEST(Sampler, keepsBelowCeilingsThatLieBelowEveryTrainingHeight)
{
    for (const double ceiling : {-0.9, -10.0, -1e6, -1e300}) {
        const GibbsDraws draws =
            sampleHeights(models().paf, paperProblem(ceiling, CeilingRule::Truncate));
        ASSERT_EQ(draws.bins.size(), static_cast<std::size_t>(kBins));
        for (const Eigen::MatrixXd& bin : draws.draws) {
            EXPECT_TRUE(bin.allFinite()) << ceiling;
            EXPECT_LE(bin.maxCoeff(), ceiling);
        }
    }
}

TEST(Sampler, chainsClampedFarBelowAreConstant)
{
    GibbsProblem problem = paperProblem(-10.0, CeilingRule::Clamp);
    problem.keptPerChain = 2000;
    problem.stopEarly = true;
    const GibbsDraws draws = sampleHeights(models().paf, problem);
    EXPECT_EQ(draws.ending, Ending::Converged);
    for (const Eigen::MatrixXd& bin : draws.draws) {
        EXPECT_EQ(bin.minCoeff(), -10.0);
        EXPECT_EQ(bin.maxCoeff(), -10.0);
        EXPECT_LT(bin.rows(), 2000);
    }
}

/// Returns an estimate of one bin from these draws.
TerrainEstimate concluded(const Eigen::MatrixXd& draws, double ceiling)
{
    TerrainEstimate estimate;
    estimate.ceiling.fill(std::numeric_limits<double>::infinity());
    estimate.ceiling[9] = ceiling;
    const GibbsDraws drawn{{9}, {draws}, Ending::Sweeps};
    summariseDraws(estimate, 9, draws, Origin::Sampled, Centre::Mean);
    conclude(estimate, drawn, {});
    return estimate;
}

TEST(Estimate, stuckChainsConvergeOnlyAtTheirCeiling)
{
    Eigen::MatrixXd draws = Eigen::MatrixXd::Constant(100, 8, -0.2);
    const double none = std::numeric_limits<double>::infinity();
    for (const double ceiling : {none, -0.1, -0.3}) {
        const TerrainEstimate e = concluded(draws, ceiling);
        EXPECT_FALSE(e.converged) << ceiling;
        EXPECT_EQ(e.rhat[9], kRhatNever);
        ASSERT_EQ(e.warnings.size(), 1U);
        EXPECT_NE(e.warnings[0].english().find("not converged"), std::string::npos);
    }
    EXPECT_TRUE(concluded(draws, -0.2).converged);
    EXPECT_TRUE(concluded(draws, -0.2).warnings.empty());
    draws.col(5).setConstant(-0.25);
    EXPECT_FALSE(concluded(draws, -0.2).converged);
    EXPECT_FALSE(concluded(draws, none).converged);
    const Eigen::MatrixXd many = draws.replicate(1, 100);  // 800 chains, as many effective draws
    EXPECT_FALSE(concluded(many, -0.2).converged);
}

TEST(Settings, refuseValuesBeyondIntegerOrMemory)
{
    for (const Method method : {Method::Pafc, Method::Clearance, Method::Local, Method::Joint}) {
        Asked odd;
        odd.settings.method = method;
        odd.settings.draws = std::numeric_limits<int>::max();
        EXPECT_THROW((void)estimateOf(odd), std::invalid_argument);
        if (isClosedForm(method)) continue;
        for (int Settings::*number : {&Settings::chains, &Settings::burnIn}) {
            odd.settings = {.method = method};
            odd.settings.*number = std::numeric_limits<int>::max();
            EXPECT_THROW((void)estimateOf(odd), std::invalid_argument);
        }
    }
}

TEST(Sampler, withoutAnyFreeBinIsEmpty)
{
    GibbsProblem problem = paperProblem(1.0, CeilingRule::Truncate);
    problem.known = someScene().truth;
    EXPECT_TRUE(sampleHeights(models().paf, problem).bins.empty());
}

TEST(Sampler, warnsWhereAModelNeededAJitter)
{
    ModelData data = modelData();
    data.paf.bins[4].noiseSd = 0.0;
    data.paf.bins[4].lengthScale.setConstant(1e4);
    const Models singular(data, robot());
    Asked asked;
    asked.settings.method = Method::Pafc;
    asked.settings.contacts = ContactRule::None;
    asked.settings.draws = 16;
    for (const int inducing : {0, 20}) {
        asked.settings.inducing = inducing;
        const TerrainEstimate e =
            estimateTerrain(asked.scene.s, {}, robot(), singular, asked.settings);
        expectSound(e, "singular model");
        EXPECT_EQ(std::count_if(e.warnings.begin(), e.warnings.end(),
                                [](const Message& w) {
                                    return w.english().find("model of bin +0.1 m is singular")
                                        != std::string::npos;
                                }),
                  1)
            << inducing;
    }
}

}  // namespace
}  // namespace terratact
