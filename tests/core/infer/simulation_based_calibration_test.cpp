// Simulation-based calibration of the Gibbs sampler. Given conditionals of one joint distribution,
// it must draw from that joint's posterior, ceilings included.
//
// The model is a Gaussian over the eleven bins, cut off above the ceilings; truths are drawn by
// rejection. Two bins are known. The exact conditionals of the other bins are then Gaussians cut
// off at the ceiling, and the sampler gets these. Ranked among nine independent draws are the
// truth's heights, the steps between neighbours and the joint density. Each has a histogram of ten
// cells; the false alarm rate is 1e-4 per test.
//
// There are 100 sets by default. The long run of 1000 sets takes seconds:
//   TERRATACT_SBC_SETS=1000 build/headless/tests/core.infer.simulation_based_calibration_test
//
// The same verdict on the same 100 sets must reject five planted mistakes of a sampler.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <tuple>
#include <utility>

#include "tests/support/infinity.h"
#include "tests/support/linear_conditionals.h"
#include "tests/support/simulation_based_calibration.h"

namespace terratact {
namespace {

constexpr double kFalseAlarm = 1e-4;
constexpr int kDraws = 9;  // ten cells: ten ranks expected in each of 100 sets'
constexpr int kBurnIn =
    150;  // the slowest mode shrinks by 0.7 per sweep without ceilings, and faster with them

/// Smooth ground that rises to the front; neighbours have a correlation of 0.7 [m].
const Eigen::VectorXd& priorMean()
{
    static const Eigen::VectorXd mean = Eigen::VectorXd::LinSpaced(kBins, -0.30, 0.10);
    return mean;
}

const Eigen::MatrixXd& priorCovariance()
{
    static const Eigen::MatrixXd covariance = [] {
        Eigen::MatrixXd C(kBins, kBins);
        const auto sd = [](Eigen::Index i) { return 0.04 + 0.006 * static_cast<double>(i); };
        for (Eigen::Index i = 0; i < kBins; ++i)
            for (Eigen::Index j = 0; j < kBins; ++j)
                C(i, j) = sd(i) * sd(j) * std::pow(0.7, std::abs(static_cast<double>(i - j)));
        return C;
    }();
    return covariance;
}

const LinearConditionals& exact()
{
    static const LinearConditionals conditionals =
        exactConditionals(priorMean(), priorCovariance());
    return conditionals;
}

/// Ceilings over bins 0 … 6, between 0.8 sd below and 0.8 sd above the mean.
Heights someCeilings()
{
    constexpr std::array kDeviations{0.4, -0.6, 0.8, -0.2, 0.5, -0.8, -0.3};
    Heights ceiling;
    ceiling.fill(kInfinity);
    for (std::size_t i = 0; i < kDeviations.size(); ++i)
        ceiling[i] = exact().startMean[static_cast<Eigen::Index>(i)]
                   + kDeviations[i] * exact().startSd[static_cast<Eigen::Index>(i)];
    return ceiling;
}

Heights noCeilings()
{
    Heights ceiling;
    ceiling.fill(kInfinity);
    return ceiling;
}

/// Truths from the prior below the ceilings; bins 4 and 8 are known.
class Prior {
public:
    explicit Prior(const Heights& ceiling) : ceiling_(ceiling) {}

    SimulatedSet next()
    {
        SimulatedSet set;
        do set.truth = draw();
        while (!belowCeilings(set.truth));
        for (const std::size_t i : {4U, 8U}) set.problem.known[i] = set.truth[i];
        set.problem.ceiling = ceiling_;
        return set;
    }

private:
    Heights draw()
    {
        Eigen::VectorXd z(kBins);
        for (double& x : z) x = normal_(rng_);
        Heights h{};
        Eigen::Map<Eigen::VectorXd>(h.data(), kBins) = priorMean() + L_ * z;
        return h;
    }

    bool belowCeilings(const Heights& h) const
    {
        for (std::size_t i = 0; i < kBins; ++i)
            if (h[i] > ceiling_[i]) return false;
        return true;
    }

    Heights ceiling_;
    Eigen::MatrixXd L_ = priorCovariance().llt().matrixL();
    std::mt19937_64 rng_{20150205};
    std::normal_distribution<double> normal_;
};

/// Returns the heights of the unknown bins (all but 4 and 8) and the steps to the next bin. The
/// last one is (h − mean)ᵀ C⁻¹ (h − mean).
Eigen::VectorXd quantities(const Heights& heights)
{
    static const Eigen::LLT<Eigen::MatrixXd> C(priorCovariance());
    const Eigen::Map<const Eigen::VectorXd> h(heights.data(), kBins);
    Eigen::VectorXd q(9 + 10 + 1);
    q << h.head(4), h.segment(5, 3), h.tail(2), h.tail(10) - h.head(10),
        C.matrixL().solve(h - priorMean()).squaredNorm();
    return q;
}

int setsFromEnvironment()
{
    const char* const text = std::getenv("TERRATACT_SBC_SETS");
    return text ? std::stoi(text) : 100;
}

double pValue(int sets, const Heights& ceiling,
              const std::function<GibbsDraws(const GibbsProblem&)>& sample)
{
    Prior prior(ceiling);
    return calibrationRanks(
               sets, kDraws, kBurnIn, [&] { return prior.next(); }, sample, quantities)
        .pValue();
}

// ---- the sampler as it is

class Calibration : public testing::TestWithParam<std::tuple<ScanOrder, bool>> {};

TEST_P(Calibration, ranksTheTruthUniformly)
{
    const auto [scan, withCeilings] = GetParam();
    const double p = pValue(setsFromEnvironment(), withCeilings ? someCeilings() : noCeilings(),
                            [scan = scan](GibbsProblem problem) {
                                problem.scan = scan;
                                return sampleStates(exact(), problem);
                            });
    RecordProperty("p", std::to_string(p));
    EXPECT_GT(p, kFalseAlarm);
}

INSTANTIATE_TEST_SUITE_P(OfTheSampler, Calibration,
                         testing::Combine(testing::Values(ScanOrder::Forward, ScanOrder::Reverse,
                                                          ScanOrder::Random),
                                          testing::Bool()),
                         [](const auto& test) {
                             return std::string(name(std::get<0>(test.param)))
                                  + (std::get<1>(test.param) ? "WithCeilings" : "Free");
                         });

// ---- mistakes that the verdict must find in 100 sets

double pValueOfMistake(const Heights& ceiling,
                       const std::function<GibbsDraws(const GibbsProblem&)>& sample)
{
    return pValue(100, ceiling, sample);
}

TEST(CalibrationFinds, aWrongSd)
{
    LinearConditionals narrow = exact();
    narrow.sd *= 0.6;
    for (const Heights& ceiling : {noCeilings(), someCeilings()})
        EXPECT_LT(pValueOfMistake(ceiling,
                                  [&](const GibbsProblem& p) { return sampleStates(narrow, p); }),
                  kFalseAlarm);
}

TEST(CalibrationFinds, clampingWhereTheModelTruncates)
{
    EXPECT_LT(pValueOfMistake(someCeilings(),
                              [](GibbsProblem problem) {
                                  problem.rule = CeilingRule::Clamp;
                                  return sampleStates(exact(), problem);
                              }),
              kFalseAlarm);
}

TEST(CalibrationFinds, theCeilingsOfTwoBinsSwapped)
{
    EXPECT_LT(pValueOfMistake(someCeilings(),
                              [](GibbsProblem problem) {
                                  std::swap(problem.ceiling[1], problem.ceiling[2]);
                                  return sampleStates(exact(), problem);
                              }),
              kFalseAlarm);
}

/// Scene that keeps the others' states of its first call.
class StaleScene final : public SceneConditionals {
public:
    explicit StaleScene(std::unique_ptr<SceneConditionals> scene) : scene_(std::move(scene)) {}

    void predict(std::size_t k, const Eigen::MatrixXd& states, Eigen::VectorXd& mean,
                 Eigen::VectorXd& variance) override
    {
        if (first_.size() == 0) first_ = states;
        scene_->predict(k, first_, mean, variance);
    }

private:
    std::unique_ptr<SceneConditionals> scene_;
    Eigen::MatrixXd first_;
};

class Stale final : public Conditionals {
public:
    StartDraw start(int bin) const override { return exact().start(bin); }
    std::unique_ptr<SceneConditionals> at(const Heights& known,
                                          const std::vector<int>& unknown) const override
    {
        return std::make_unique<StaleScene>(exact().at(known, unknown));
    }
};

TEST(CalibrationFinds, neighboursThatAreNeverUpdated)
{
    for (const Heights& ceiling : {noCeilings(), someCeilings()})
        EXPECT_LT(pValueOfMistake(ceiling,
                                  [](const GibbsProblem& p) { return sampleStates(Stale{}, p); }),
                  kFalseAlarm);
}

TEST(CalibrationFinds, theConditionalOfTheNextBin)
{
    // Inputs keep their order, so the next bin takes the place that the conditional expects for
    // this one.
    LinearConditionals shifted = exact();
    for (Eigen::Index i = 0; i + 1 < kBins; ++i) {
        shifted.intercept[i] = exact().intercept[i + 1];
        shifted.sd[i] = exact().sd[i + 1];
        shifted.weights.row(i) = exact().weights.row(i + 1);
        std::swap(shifted.weights(i, i), shifted.weights(i, i + 1));
    }
    for (const Heights& ceiling : {noCeilings(), someCeilings()})
        EXPECT_LT(pValueOfMistake(ceiling,
                                  [&](const GibbsProblem& p) { return sampleStates(shifted, p); }),
                  kFalseAlarm);
}

}  // namespace
}  // namespace terratact
