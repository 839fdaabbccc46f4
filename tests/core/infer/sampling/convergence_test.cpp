#include "core/infer/sampling/convergence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace terratact {
namespace {

struct Reference {
    std::string name;
    double rhat = 0.0, ess = 0.0;
    Eigen::MatrixXd draws;
};

/// tests/data/make_posterior_reference.R explains the lines.
std::vector<Reference> readReference()
{
    std::ifstream file(TERRATACT_SOURCE_DIR "/tests/data/posterior_reference.csv");
    std::vector<Reference> all;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream fields(line);
        Reference r;
        std::string rhat, ess, chains;
        std::getline(fields, r.name, ',');
        std::getline(fields, rhat, ',');
        std::getline(fields, ess, ',');
        std::getline(fields, chains, ',');
        r.rhat = std::stod(rhat);
        r.ess = std::stod(ess);
        std::vector<double> x;
        for (double value = 0.0; fields >> value;) x.push_back(value);
        const Eigen::Index columns = std::stol(chains);
        r.draws = Eigen::Map<Eigen::MatrixXd>(
            x.data(), static_cast<Eigen::Index>(x.size()) / columns, columns);
        all.push_back(std::move(r));
    }
    return all;
}

TEST(RankNormalisedRhat, equalsThePosteriorPackage)
{
    const auto references = readReference();
    ASSERT_EQ(references.size(), 20U);
    for (const Reference& r : references)
        EXPECT_NEAR(RankedDraws(r.draws).rhat(), r.rhat, 1e-10 * r.rhat) << r.name;
}

TEST(BulkEss, equalsThePosteriorPackage)
{
    const auto references = readReference();
    ASSERT_EQ(references.size(), 20U);
    for (const Reference& r : references)
        EXPECT_NEAR(RankedDraws(r.draws).ess(), r.ess, 1e-10 * r.ess) << r.name;
}

TEST(Convergence, constantDrawsDoNotConverge)
{
    Eigen::MatrixXd fixed = Eigen::MatrixXd::Constant(250, 4, -0.137);
    EXPECT_EQ(RankedDraws(fixed).rhat(), kRhatNever);
    EXPECT_EQ(RankedDraws(fixed).ess(), 4.0);
    fixed.conservativeResize(251, Eigen::NoChange);
    fixed.row(125).setZero();  // the middle belongs to neither half
    fixed.row(250).setConstant(-0.137);
    EXPECT_EQ(RankedDraws(fixed).rhat(), kRhatNever);
    EXPECT_EQ(RankedDraws(fixed).ess(), 4.0);
}

TEST(Convergence, drawsAtTheirBoundHaveConverged)
{
    const Eigen::MatrixXd held = Eigen::MatrixXd::Constant(250, 4, -0.137);
    EXPECT_EQ(RankedDraws(held, {}, -0.137).rhat(), 1.0);
    EXPECT_EQ(RankedDraws(held, {}, -0.137).ess(), 1000.0);
    // above the ceiling, and below it, where no rule bounds draws
    for (const double elsewhere : {-0.136, -0.2}) {
        EXPECT_EQ(RankedDraws(held, {}, elsewhere).rhat(), kRhatNever);
        EXPECT_EQ(RankedDraws(held, {}, elsewhere).ess(), 4.0);
    }
    Eigen::MatrixXd one = held;
    one.col(2).setConstant(std::nextafter(-0.137, -1.0));  // one chain has another height
    EXPECT_EQ(RankedDraws(one, {}, -0.137).rhat(), kRhatNever);
    EXPECT_EQ(RankedDraws(held.topRows(3), {}, -0.137).rhat(), kRhatNever);
    EXPECT_EQ(RankedDraws(held.topRows(5), {}, -0.137).ess(), 4.0);
}

TEST(Convergence, freeDrawsIgnoreTheBound)
{
    for (const Reference& r : readReference())
        for (const double bound : {r.draws.minCoeff(), r.draws.mean(), r.draws.maxCoeff()}) {
            EXPECT_EQ(RankedDraws(r.draws, {}, bound).rhat(), RankedDraws(r.draws).rhat());
            EXPECT_EQ(RankedDraws(r.draws, {}, bound).ess(), RankedDraws(r.draws).ess());
        }
}

TEST(Convergence, chainsStuckApartDoNotConverge)
{
    for (const Eigen::Index chains : {2, 4, 500}) {  // 500: as many effective draws
        Eigen::MatrixXd frozen(250, chains);
        for (Eigen::Index c = 0; c < chains; ++c)
            frozen.col(c).setConstant(0.01 * static_cast<double>(c));
        EXPECT_EQ(RankedDraws(frozen).rhat(), kRhatNever);
        EXPECT_EQ(RankedDraws(frozen).ess(), static_cast<double>(chains));
        EXPECT_EQ(RankedDraws(frozen, {}, 0.0).rhat(), kRhatNever);
    }
    Eigen::MatrixXd hardly = Eigen::MatrixXd::Constant(250, 4, -0.137);
    hardly.col(3).setConstant(std::nextafter(-0.137, 0.0));
    EXPECT_EQ(RankedDraws(hardly).rhat(), kRhatNever);
    Eigen::MatrixXd moved = Eigen::MatrixXd::Constant(250, 4, -0.137);
    moved.bottomRows(125).setConstant(0.2);  // all together
    EXPECT_EQ(RankedDraws(moved).rhat(), kRhatNever);
    EXPECT_EQ(RankedDraws(moved).ess(), 4.0);
}

TEST(Convergence, twoAlternatingHeightsAreJudgedUnfolded)
{
    Eigen::MatrixXd turns(100, 2);
    for (Eigen::Index i = 0; i < turns.size(); ++i) turns(i) = (i * 7 % 10) < 5 ? 0.0 : 1.0;
    EXPECT_NEAR(RankedDraws(turns).rhat(), 1.0, 0.05);
    EXPECT_GT(RankedDraws(turns).ess(), 100.0);
}

TEST(Convergence, tooFewDrawsDoNotConverge)
{
    for (Eigen::Index n = 1; n < 6; ++n) {
        const Eigen::MatrixXd few = Eigen::MatrixXd::Random(n, 3);
        EXPECT_EQ(RankedDraws(few).ess(), 3.0) << n;
        if (n < 4) {
            EXPECT_EQ(RankedDraws(few).rhat(), kRhatNever) << n;
        }
    }
}

TEST(Convergence, isFiniteForEveryShapeAndManyTies)
{
    for (Eigen::Index n = 1; n <= 24; ++n)
        for (Eigen::Index chains = 1; chains <= 5; ++chains)
            for (const double levels : {1.0, 2.0, 1e6}) {
                const Eigen::MatrixXd x =
                    (Eigen::MatrixXd::Random(n, chains) * levels).array().round();
                ASSERT_TRUE(std::isfinite(RankedDraws(x).rhat())) << n << " × " << chains;
                ASSERT_TRUE(std::isfinite(RankedDraws(x).ess())) << n << " × " << chains;
                ASSERT_GT(RankedDraws(x).ess(), 0.0) << n << " × " << chains;
            }
}

TEST(Convergence, refusesNoDrawsAndNan)
{
    Eigen::MatrixXd x = Eigen::MatrixXd::Random(10, 2);
    x(3, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(RankedDraws(x).rhat(), std::invalid_argument);
    EXPECT_THROW(RankedDraws(x).ess(), std::invalid_argument);
    EXPECT_THROW(RankedDraws(Eigen::MatrixXd()).rhat(), std::invalid_argument);
    EXPECT_THROW(RankedDraws(Eigen::MatrixXd(0, 4)).ess(), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
