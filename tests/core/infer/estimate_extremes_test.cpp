// Estimates of extreme scenes: each is right or refused with a text, without NaN and without a
// hang.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/atem/arm_choice.h"
#include "core/infer/closed_form.h"
#include "core/infer/estimator.h"
#include "core/infer/sampling/convergence.h"
#include "core/infer/sampling/draw_summary.h"
#include "core/infer/sampling/gibbs.h"
#include "core/learn/gp/cholesky.h"
#include "core/learn/gp/scene_conditional.h"
#include "core/terrain/kinematic_reconstruction.h"
#include "tests/support/counted_blas.h"
#include "tests/support/random_model.h"
#include "tests/support/toy_clearance.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

const RobotModel& robot()
{
    static const RobotModel model = absolem();
    return model;
}

/// Returns toyModel with hyper-parameters for the conditionals over clearances.
ModelData modelFor(int runs, std::uint64_t seed)
{
    ModelData model = toyModel(runs, seed);
    const auto data = plausibleConditionals(clearanceTraining(model, robot()));
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        model.clearance.conditionalOpen[i] = data.at(bin, Regime::Open).hyper;
        model.clearance.conditionalCovered[i] = data.at(bin, Regime::Covered).hyper;
    }
    return model;
}

const ModelData& modelData()
{
    static const ModelData data = modelFor(12, 1);
    return data;
}

const Models& models()
{
    static const Models toy(modelData(), robot());
    return toy;
}

Scene someScene()
{
    static const Scene scene = someScenes(2, 99).front();
    return scene;
}

std::vector<double> numbersOf(const TerrainEstimate& e)
{
    std::vector<double> all{e.novelty};
    for (const Heights& h : {e.mean, e.sd, e.q10, e.q90, e.height, e.rhat, e.ess})
        all.insert(all.end(), h.begin(), h.end());
    for (const Heights& h : e.draws) all.insert(all.end(), h.begin(), h.end());
    return all;
}

void expectSound(const TerrainEstimate& e, const std::string& what)
{
    for (const double x : numbersOf(e)) ASSERT_TRUE(std::isfinite(x)) << what;
    for (std::size_t i = 0; i < kBins; ++i) {
        EXPECT_LE(e.q10[i], e.q90[i]) << what << ", bin " << i;
        EXPECT_GE(e.sd[i], 0.0) << what << ", bin " << i;
        EXPECT_FALSE(std::isnan(e.ceiling[i])) << what << ", bin " << i;
        if (usesCeiling(e.settings.method) && e.origin[i] == Origin::Sampled
            && e.settings.ceiling != CeilingRule::None) {
            EXPECT_LE(e.q90[i], e.ceiling[i]) << what << ", bin " << i;
        }
    }
}

struct Asked {
    Scene scene = someScene();
    std::vector<ArmReading> arm;
    Settings settings;
};

TerrainEstimate estimateOf(const Asked& asked, const Watch& watch = {},
                           const RobotModel& of = robot())
{
    return estimateTerrain(asked.scene.s, asked.arm, of, models(), asked.settings, watch);
}

/// Returns the robot with its IMU raised: robot and ground lie deeper in the DEM frame.
RobotModel loweredBy(double metres)
{
    RobotModel low = robot();
    low.imu.z += metres;
    return low;
}

class EveryMethod : public testing::TestWithParam<Method> {
protected:
    Asked asked()
    {
        Asked a;
        a.settings.method = GetParam();
        a.settings.draws = 200;
        a.settings.burnIn = 10;
        return a;
    }
    std::string what() { return std::string(name(GetParam())); }
};

TEST_P(EveryMethod, answersWithNoBinUnknown)
{
    Asked all = asked();
    for (int bin = 0; bin < kBins; ++bin)
        all.arm.push_back({bin, *all.scene.truth[static_cast<std::size_t>(bin)], 0.03});
    const TerrainEstimate e = estimateOf(all);
    expectSound(e, what());
    for (std::size_t i = 0; i < kBins; ++i) {
        EXPECT_EQ(e.origin[i], Origin::Arm);
        EXPECT_NEAR(e.mean[i], *all.scene.truth[i], 0.1) << what() << ", bin " << i;
    }
}

TEST_P(EveryMethod, answersWithEveryBinUnknown)
{
    Asked nothing = asked();
    nothing.settings.contacts = ContactRule::None;
    const TerrainEstimate e = estimateOf(nothing);
    expectSound(e, what());
    EXPECT_EQ(std::count(e.origin.begin(), e.origin.end(), Origin::Sampled), kBins);
}

TEST_P(EveryMethod, oneDrawOfOneChainNeverConverges)
{
    for (const int draws : {1, 2, 3, 5}) {
        Asked one = asked();
        one.settings.draws = draws;
        one.settings.chains = 1;
        one.settings.burnIn = 0;
        const TerrainEstimate e = estimateOf(one);
        expectSound(e, what());
        EXPECT_EQ(e.draws.size(), static_cast<std::size_t>(draws));
        if (!isClosedForm(GetParam())) {
            EXPECT_FALSE(e.converged) << draws;
        }
    }
}

TEST_P(EveryMethod, answersContradictoryContactsAndSaysSo)
{
    Asked odd = asked();
    odd.settings.contacts = ContactRule::Any;
    odd.scene.s.force.fill(150.0);
    odd.scene.s.front = 1.2;  // an upright flipper with every element loaded
    const auto contacts = reconstructContacts(robot(), odd.scene.s, 2.0, false).contacts;
    ASSERT_GT(contacts.size(), 1U);
    odd.arm.push_back({contacts.front().bin, -1.0, 0.03});
    if (GetParam() == Method::Clearance) {  // training never had uncovered ground so far ahead
        EXPECT_THROW((void)estimateOf(odd), NotLearnt);
        return;
    }
    const TerrainEstimate e = estimateOf(odd);
    expectSound(e, what());
    EXPECT_EQ(e.origin[static_cast<std::size_t>(contacts.front().bin)], Origin::Arm);
    if (usesForces(GetParam())) {
        EXPECT_TRUE(std::any_of(e.warnings.begin(), e.warnings.end(), [](const Message& w) {
            return w.english().find("contact and arm disagree") != std::string::npos;
        })) << what();
    }
}

TEST_P(EveryMethod, takesAProbeTenDeviationsOutsideItsPrior)
{
    Asked own = asked();
    own.settings.hazardRate = 0.0;  // a hazard's sd would carry the probe hundreds of metres away
    const TerrainEstimate before = estimateOf(own);
    for (const int bin : {0, 5, 10})
        for (const double sds : {-10.0, 10.0, -1000.0}) {
            const auto i = static_cast<std::size_t>(bin);
            Asked probed = own;
            probed.arm.push_back({bin, before.mean[i] + sds * std::max(before.sd[i], 0.02), 0.03});
            const TerrainEstimate e = estimateOf(probed);
            expectSound(e, what() + ", bin " + std::to_string(bin));
            EXPECT_EQ(e.origin[i], Origin::Arm);
            const double reading = probed.arm.front().height;
            if (isOfPaper(GetParam())) {
                EXPECT_EQ(e.mean[i], reading);
                // a few sd away, or more than half of the distance
            } else if (reading < e.ceiling[i]) {
                const double near = 4.0 * std::max(e.sd[i], 0.03);
                EXPECT_NEAR(e.mean[i], reading,
                            std::max(near, 0.5 * std::abs(reading - before.mean[i])))
                    << what() << ", bin " << bin << ", " << sds << " deviations";
            }
        }
}

TEST_P(EveryMethod, keepsBelowCeilingsThatLieBelowEveryTrainingHeight)
{
    for (const double by : {1.0, 10.0, 1e6})
        for (const ContactRule contacts : {ContactRule::None, ContactRule::Any}) {
            Asked deep = asked();
            deep.scene.s.pitch = 0.0;  // otherwise the IMU is far ahead, too
            deep.settings.draws = 64;
            deep.settings.contacts = contacts;
            const TerrainEstimate e = estimateOf(deep, {}, loweredBy(by));
            const std::string which = what() + ", by " + std::to_string(by);
            expectSound(e, which);
            int below = 0;
            for (std::size_t i = 0; i < kBins; ++i) {
                if (e.origin[i] != Origin::Sampled || std::isinf(e.ceiling[i])) continue;
                ASSERT_LT(e.ceiling[i], modelData().heights.minCoeff()) << which;
                if (GetParam() == Method::Pa) continue;  // uses no ceiling
                ++below;
                const double most =
                    e.ceiling[i] + (isClosedForm(GetParam()) ? kDeepestSinking : 0.0);
                for (const double height : {e.mean[i], e.height[i], e.q10[i], e.q90[i]})
                    EXPECT_LE(height, most + 1e-12 * by) << which << ", bin " << i;
                for (const Heights& draw : e.draws) EXPECT_LE(draw[i], most) << which;
            }
            if (GetParam() != Method::Pa) {
                EXPECT_GE(below, 3) << which;
            }
        }
}

TEST_P(EveryMethod, answersOrRefusesEveryPose)
{
    int answered = 0, refused = 0;
    for (const double pitch : {-89.0, -45.0, 45.0, 89.0})
        for (const double front : {-180.0, -90.0, 0.0, 180.0})
            for (const double rear : {-180.0, 90.0, 180.0}) {
                Asked odd = asked();
                odd.settings.draws = 16;
                odd.settings.burnIn = 2;
                odd.scene.s.pitch = pitch / 57.29577951308232;
                odd.scene.s.front = front / 57.29577951308232;
                odd.scene.s.rear = rear / 57.29577951308232;
                try {
                    expectSound(estimateOf(odd), what() + " at " + std::to_string(pitch) + ", "
                                                     + std::to_string(front));
                    ++answered;
                } catch (const NotLearnt& why) {
                    EXPECT_NE(std::string(why.what()).find("training scenes"), std::string::npos);
                    ++refused;
                }
            }
    std::cout << what() << ": " << answered << " answered, " << refused << " refused\n";
    EXPECT_EQ(answered + refused, 48);
    if (GetParam() == Method::Clearance) {  // distinguishes covered and open bins
        EXPECT_GE(answered, 1);
        EXPECT_GE(refused, 1);
    } else {
        EXPECT_EQ(refused, 0);
    }
}

TEST_P(EveryMethod, refusesWhatIsNotANumber)
{
    for (double Proprioception::*field :
         {&Proprioception::pitch, &Proprioception::front, &Proprioception::rear})
        for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
            Asked odd = asked();
            odd.scene.s.*field = bad;
            EXPECT_THROW((void)estimateOf(odd), std::invalid_argument) << what();
        }
    Asked odd = asked();
    odd.scene.s.force[2] = std::nan("");
    if (usesForces(GetParam())) {
        EXPECT_THROW((void)estimateOf(odd), std::invalid_argument) << what();
    }
    odd = asked();
    odd.arm.push_back({4, std::nan(""), 0.03});
    EXPECT_THROW((void)estimateOf(odd), std::invalid_argument) << what();
}

TEST_P(EveryMethod, isCancelledAtEveryPollAndThenRepeatable)
{
    Asked quick = asked();
    quick.settings.draws = isClosedForm(GetParam()) ? 30000 : 16;
    quick.settings.stopEarly = !isClosedForm(GetParam());
    quick.settings.burnIn = 1;
    int asking = 0;
    Watch counting;
    counting.cancelled = [&] {
        ++asking;
        return false;
    };
    const TerrainEstimate expected = estimateOf(quick, counting);
    const int fewest = asking;
    EXPECT_GT(fewest, 20);
    const Models fresh(modelData(), robot());
    const auto run = [&](int last) {
        int left = last;
        Watch watch;
        watch.cancelled = [&] {
            ++asking;
            return --left == 0;
        };
        return estimateTerrain(quick.scene.s, {}, robot(), fresh, quick.settings, watch);
    };
    // Models start cold: every cancelled run leaves its models to the next one.
    for (const int last : {1, 2, 3, 5, 8, 13, 21, 34, 55}) {
        if (last > fewest) break;
        EXPECT_THROW((void)run(last), Cancelled) << last;
    }
    EXPECT_EQ(run(-1), expected);
    asking = 0;
    EXPECT_EQ(run(-1), expected);
    const int all = asking;
    for (int last = 1; last <= all; last += std::max(1, all / 60))
        EXPECT_THROW((void)run(last), Cancelled) << last << " of " << all;
    EXPECT_EQ(run(-1), expected);
}

/// Returns the largest BLAS work of a computation between two polls.
BlasWork longestGap(const std::function<void(const Poll&)>& compute)
{
    BlasWork last = blasWork();
    BlasWork most;
    const auto seen = [&] {
        const BlasWork now = blasWork();
        most.multiplications =
            std::max(most.multiplications, now.multiplications - last.multiplications);
        most.read = std::max(most.read, now.read - last.read);
        last = now;
    };
    compute(seen);
    seen();
    return most;
}

TEST(Cancelling, largeModelPollsAfterBoundedWork)
{
    constexpr int kRows = 2500;
    std::mt19937_64 rng(3);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd X(kRows, 3);
    for (double& x : X.reshaped()) x = normal(rng);
    const Eigen::VectorXd y = X.col(0).array().sin();
    const Hyperparameters hyper{Eigen::Vector3d::Ones(), 1.0, 0.1};
    const BlasWork gap = longestGap([&](const Poll& poll) {
        const GaussianProcess gp(X, y, hyper, 0.0, poll);
        (void)SceneConditional(gp, Eigen::Vector3d::Zero(), {0}, Precision::Single, poll);
        (void)SceneConditional(gp, Eigen::Vector3d::Zero(), {0}, Precision::Double, poll);
        (void)GaussianProcess::sparse(X, y, 400, hyper, 0.0, poll)->usable(Precision::Single, poll);
    });
    EXPECT_LE(gap.multiplications, 1.3 * kMaxMultiplications);
    EXPECT_GT(gap.multiplications, 0.1 * kMaxMultiplications);  // they are counted
    const BlasWork solving = longestGap([&](const Poll& poll) {
        const Eigen::MatrixXd R = Eigen::MatrixXd::Identity(3500, 3500);
        Eigen::VectorXd x = R.col(0);
        Eigen::MatrixXd several = R.leftCols(3);
        solveWithFactor(R, x, poll);
        multiplyTransposed(R, several, poll);
        solveTransposed(R, several, poll);
        (void)reciprocalCondition(R, 1.0, poll);
    });
    EXPECT_LE(solving.read, 1.1 * kMaxRead);
}

/// Returns the number of polls of a computation.
int questions(const std::function<void(const Poll&)>& compute)
{
    int asked = 0;
    compute([&] { ++asked; });
    return asked;
}

TEST(Cancelling, pollsGrowWithTheNumberOfDraws)
{
    constexpr Eigen::Index kDraws = 300000;
    const auto least = [](int unitsPerDraw) {
        return static_cast<int>(unitsPerDraw * kDraws / PolledWork::kBetweenPolls);
    };
    std::mt19937_64 rng(3);
    std::normal_distribution<double> normal;
    GibbsDraws draws;
    draws.bins = {9};
    draws.draws = {Eigen::MatrixXd(kDraws / 100, 100)};
    for (double& x : draws.draws[0].reshaped()) x = normal(rng);

    EXPECT_GE(questions([&](const Poll& poll) { (void)RankedDraws(draws.draws[0], poll).rhat(); }),
              least(2 * 14));  // sorts twice
    EXPECT_GE(questions([&](const Poll& poll) { (void)RankedDraws(draws.draws[0], poll).ess(); }),
              least(14));
    TerrainEstimate estimate;
    EXPECT_GE(questions([&](const Poll& poll) {
                  summariseDraws(estimate, 9, draws.draws[0], Origin::Sampled, Centre::Mean, poll);
              }),
              least(3 * 14));
    EXPECT_GE(questions([&](const Poll& poll) { conclude(estimate, draws, {}, poll); }), least(11));
    EXPECT_GE(questions([&](const Poll& poll) { (void)finite(estimate, poll); }), least(11));
    EXPECT_GE(questions([&](const Poll& poll) { (void)adviseProbe(estimate, robot(), 0.1, poll); }),
              least(48 * 2));  // once for every reading
    for (const Method method : {Method::Local, Method::Joint}) {
        Asked many;
        many.settings.method = method;
        many.settings.draws = kDraws;
        many.settings.stopEarly = false;
        EXPECT_GE(questions([&](const Poll& poll) {
                      Watch watch;
                      watch.cancelled = [&] {
                          poll();
                          return false;
                      };
                      (void)estimateOf(many, watch);
                  }),
                  least(22 + 22 + 11));
    }
}

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

TEST(Sampler, saysWhereAModelNeededAJitter)
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

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod, testing::ValuesIn(kMethods),
                         [](const auto& method) { return std::string(name(method.param)); });

}  // namespace
}  // namespace terratact
