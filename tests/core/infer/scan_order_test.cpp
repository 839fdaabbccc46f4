// Order in which the sampler visits the bins. It has no effect if the conditionals belong to one
// joint distribution. Otherwise the last bin of a sweep matters.
#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include "core/infer/sampling/gibbs.h"
#include "tests/support/linear_conditionals.h"

namespace terratact {
namespace {

constexpr ScanOrder kOrders[] = {ScanOrder::Forward, ScanOrder::Reverse, ScanOrder::Random};

GibbsProblem problemWith(std::initializer_list<int> unknown, ScanOrder scan)
{
    GibbsProblem problem;
    problem.known.fill(0.0);
    for (const int i : unknown) problem.known[static_cast<std::size_t>(i)].reset();
    problem.ceiling.fill(std::numeric_limits<double>::infinity());
    problem.scan = scan;
    problem.chains = 100;
    problem.burnIn = 30;
    problem.keptPerChain = 400;
    return problem;
}

double meanProduct(const GibbsDraws& draws, std::size_t a, std::size_t b)
{
    return (draws.draws[a].array() * draws.draws[b].array()).mean();
}

/// Bins 3 and 6 with x₃ | x₆ ~ N(0.9 x₆, 1) and x₆ | x₃ ~ N(0, 1), which no joint distribution has.
LinearConditionals incompatiblePair()
{
    LinearConditionals pair;
    pair.intercept = pair.startMean = Eigen::VectorXd::Zero(kBins);
    pair.sd = pair.startSd = Eigen::VectorXd::Ones(kBins);
    pair.weights = Eigen::MatrixXd::Zero(kBins, kBins);
    pair.weights(3, 6) = 0.9;
    return pair;
}

TEST(ScanOrder, decidesTheCovarianceOfIncompatibleConditionals)
{
    // A sweep that ends with x₆ forgets x₃: covariance 0. A sweep that ends with x₃ leaves 0.9 Var
    // x₆ = 0.9. A random order does each half of the time. 40 000 draws give an sd of the mean
    // product below 0.013.
    const LinearConditionals pair = incompatiblePair();
    const double expected[] = {0.0, 0.9, 0.45};
    for (std::size_t k = 0; k < 3; ++k) {
        const GibbsDraws draws = sampleStates(pair, problemWith({3, 6}, kOrders[k]));
        EXPECT_NEAR(meanProduct(draws, 0, 1), expected[k], 0.05) << name(kOrders[k]);
        EXPECT_NEAR(meanProduct(draws, 0, 0), 1.81, 0.08) << name(kOrders[k]);
        EXPECT_NEAR(meanProduct(draws, 1, 1), 1.0, 0.05) << name(kOrders[k]);
    }
}

TEST(ScanOrder, doesNotMatterForCompatibleConditionals)
{
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(kBins, kBins);
    for (const auto& [i, j, r] : {std::tuple{2, 5, 0.6}, {5, 9, -0.5}, {2, 9, 0.1}})
        covariance(i, j) = covariance(j, i) = r;
    const LinearConditionals exact = exactConditionals(Eigen::VectorXd::Zero(kBins), covariance);
    const int bins[] = {2, 5, 9};
    for (const ScanOrder scan : kOrders) {
        const GibbsDraws draws = sampleStates(exact, problemWith({2, 5, 9}, scan));
        for (std::size_t a = 0; a < 3; ++a) {
            EXPECT_NEAR(draws.draws[a].mean(), 0.0, 0.05) << name(scan);
            for (std::size_t b = 0; b <= a; ++b)
                EXPECT_NEAR(meanProduct(draws, a, b), covariance(bins[a], bins[b]), 0.06)
                    << name(scan) << ' ' << bins[a] << ' ' << bins[b];
        }
    }
}

TEST(ScanOrder, randomOrderRepeatsForAnyNumberOfChains)
{
    const LinearConditionals pair = incompatiblePair();
    GibbsProblem problem = problemWith({3, 6}, ScanOrder::Random);
    const GibbsDraws many = sampleStates(pair, problem);
    EXPECT_EQ(many.draws, sampleStates(pair, problem).draws);
    problem.chains = 5;
    const GibbsDraws few = sampleStates(pair, problem);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(few.draws[k], many.draws[k].leftCols(5));
    problem.seed = 2;
    EXPECT_NE(sampleStates(pair, problem).draws, few.draws);
}

}  // namespace
}  // namespace terratact
