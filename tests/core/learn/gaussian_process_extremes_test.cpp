// Right or refused with a text: never a NaN, never a confident wrong number.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/learn/gaussian_process.h"
#include "core/learn/likelihood.h"
#include "core/learn/scene_conditional.h"

namespace terratact {
namespace {

using Long = long double;
using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;

struct Data {
    Eigen::MatrixXd X;
    Eigen::VectorXd y;
    Hyperparameters hyper;
};

enum class Kind { Plain, DoubledRows, Collinear, ConstantColumn, OneRowOnly };

Data dataOf(Kind kind, int U, double length, double signal, double noise)
{
    std::mt19937_64 rng(7);
    std::normal_distribution<double> normal;
    Data data{Eigen::MatrixXd(U, 3), Eigen::VectorXd(U), {}};
    for (double& x : data.X.reshaped()) x = normal(rng);
    if (kind == Kind::DoubledRows)
        for (int u = 1; u < U; u += 2) data.X.row(u) = data.X.row(u - 1);
    if (kind == Kind::Collinear) data.X.col(1) = 2.0 * data.X.col(0);
    if (kind == Kind::ConstantColumn) data.X.col(1).setConstant(4.0);
    if (kind == Kind::OneRowOnly) data.X.rowwise() = Eigen::RowVector3d(0.3, -1.0, 2.0);
    for (int u = 0; u < U; ++u) data.y[u] = std::sin(data.X(u, 0)) + 0.1 * normal(rng);
    data.hyper = {Eigen::VectorXd::Constant(3, length), signal, noise};
    return data;
}

Long squareOf(Long x)
{
    return x * x;
}

/// The textbook formulas with 64 bits of mantissa, and the jitter that the model took.
class Reference {
public:
    Reference(const Data& data, double jitter)
        : data_(data), signal2_(squareOf(data.hyper.signalSd)),
          prior_(signal2_ + squareOf(data.hyper.noiseSd))
    {
        const Eigen::Index U = data.X.rows();
        LongMatrix K(U, U);
        for (Eigen::Index j = 0; j < U; ++j) K.col(j) = covarianceWith(data.X.row(j).transpose());
        K.diagonal().array() += squareOf(data.hyper.noiseSd) + jitter * prior_;
        factor_.compute(K);
        alpha_ = factor_.solve(data.y.cast<Long>());
    }

    Normal predict(const Eigen::VectorXd& x) const
    {
        const LongVector k = covarianceWith(x);
        const LongVector v = factor_.matrixL().solve(k);
        return {static_cast<double>(k.dot(alpha_)), static_cast<double>(prior_ - v.squaredNorm())};
    }

private:
    LongVector covarianceWith(const Eigen::VectorXd& x) const
    {
        const LongVector scale = data_.hyper.lengthScale.cast<Long>();
        LongVector k(data_.X.rows());
        for (Eigen::Index u = 0; u < k.size(); ++u) {
            const LongVector z =
                (data_.X.row(u).transpose().cast<Long>() - x.cast<Long>()).cwiseQuotient(scale);
            k[u] = signal2_ * std::exp(-0.5L * z.squaredNorm());
        }
        return k;
    }

    const Data& data_;
    Long signal2_, prior_;
    Eigen::LLT<LongMatrix> factor_;
    LongVector alpha_;
};

/// The largest error so far of those that the condition number decides, as a share of what the header allows.
double worstShare = 0.0;

void note(double error, double bound)
{
    if (bound > 1e-9) worstShare = std::max(worstShare, error / bound);
}

void expectRight(const Data& data, const GaussianProcess& gp, const std::string& what)
{
    EXPECT_LE(gp.errorBound(), 1.0001e-2) << what;
    const double noise2 = std::pow(data.hyper.noiseSd, 2);
    const double prior = std::pow(data.hyper.signalSd, 2) + noise2;
    const double size = data.y.cwiseAbs().maxCoeff();
    const Reference reference(data, gp.jitter());
    Eigen::VectorXd beside = data.X.row(0).transpose();
    beside[0] += 0.4;
    for (const Eigen::VectorXd& x :
         {Eigen::VectorXd(data.X.row(0)), beside, Eigen::VectorXd(Eigen::Vector3d(50.0, -9.0, 0.0)),
          Eigen::VectorXd(Eigen::Vector3d(1e200, 0.0, -1e308))}) {
        const Normal got = gp.predict(x);
        const Normal expected = reference.predict(x);
        ASSERT_TRUE(std::isfinite(got.mean) && std::isfinite(got.variance)) << what;
        EXPECT_NEAR(got.mean, expected.mean, gp.errorBound() * size) << what;
        EXPECT_NEAR(got.variance, expected.variance, gp.errorBound() * prior) << what;
        note(std::abs(got.mean - expected.mean) / size, gp.errorBound());
        note(std::abs(got.variance - expected.variance) / prior, gp.errorBound());
        EXPECT_GT(got.variance, 0.0) << what;
        EXPECT_GE(got.variance, noise2) << what;
        EXPECT_LE(got.variance, prior * (1.0 + 1e-12)) << what;
    }
}

std::unique_ptr<GaussianProcess> built(const Data& data)
{
    try {
        return std::make_unique<GaussianProcess>(data.X, data.y, data.hyper, 0.0);
    } catch (const std::invalid_argument& refused) {
        EXPECT_GT(std::string(refused.what()).size(), 30U);
        return nullptr;
    }
}

class Extremes : public testing::TestWithParam<Kind> {};

TEST_P(Extremes, areAnsweredAsInLongDoubleOrRefused)
{
    int answered = 0, mended = 0, refused = 0;
    for (const int U : {1, 2, 40})
        for (const double length : {1e-8, 1e-3, 1.0, 1e3, 1e8})
            for (const double signal : {1e-12, 0.3, 1e6})
                for (const double noise : {0.0, 1e-12, 1e-3, 1e6}) {
                    const Data data = dataOf(GetParam(), U, length, signal, noise);
                    const std::string what =
                        std::to_string(U) + " rows, l " + std::to_string(length) + ", sf "
                        + std::to_string(signal) + ", sn " + std::to_string(noise);
                    const auto gp = built(data);
                    refused += !gp;
                    if (!gp) continue;
                    ++answered;
                    mended += gp->jitter() > 0.0;
                    EXPECT_LE(gp->jitter(), 1e-6) << what;
                    EXPECT_GE(gp->rcond(), kLeastRcond) << what;
                    if (noise >= 1e-3 * signal) {
                        EXPECT_EQ(gp->jitter(), 0.0) << what;
                    }
                    expectRight(data, *gp, what);
                }
    EXPECT_EQ(refused, 0);  // with a jitter every one of these can be answered
    EXPECT_GT(answered, 100);
    std::cout << answered << " answered, " << mended << " of them with a jitter; errors up to "
              << worstShare << " of the bound where the condition decides\n";
}

INSTANTIATE_TEST_SUITE_P(Kinds, Extremes,
                         testing::Values(Kind::Plain, Kind::DoubledRows, Kind::Collinear,
                                         Kind::ConstantColumn, Kind::OneRowOnly));

TEST(Jitter, isTheLeastThatMendsDoubledRowsAndIsKept)
{
    const auto gp = built(dataOf(Kind::DoubledRows, 20, 1.0, 0.3, 0.0));
    EXPECT_EQ(gp->jitter(), 1e-10);
    EXPECT_EQ(built(dataOf(Kind::DoubledRows, 20, 1.0, 0.3, 0.01))->jitter(), 0.0);
}

TEST(GaussianProcess, withoutAnyScaleIsRefused)
{
    EXPECT_FALSE(built(dataOf(Kind::Plain, 20, 1.0, 1e-200, 0.0)));  // its square is 0
    EXPECT_FALSE(built(dataOf(Kind::Plain, 20, 1.0, 1e200, 0.1)));   // its square is infinite
    EXPECT_FALSE(built(dataOf(Kind::Plain, 20, 1e-310, 0.3, 0.1)));  // inputs overflow
}

TEST(GaussianProcess, withOneValueThatIsNotANumberIsRefused)
{
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        Data data = dataOf(Kind::Plain, 20, 1.0, 0.3, 0.1);
        data.X(7, 1) = bad;
        EXPECT_FALSE(built(data));
        EXPECT_THROW((void)negativeLogLikelihood(data.X, data.y, data.hyper),
                     std::invalid_argument);
        data = dataOf(Kind::Plain, 20, 1.0, 0.3, 0.1);
        data.y[3] = bad;
        EXPECT_FALSE(built(data));
        const auto gp = built(dataOf(Kind::Plain, 20, 1.0, 0.3, 0.1));
        EXPECT_THROW((void)gp->predict(Eigen::Vector3d(0.0, bad, 0.0)), std::invalid_argument);
        EXPECT_THROW(SceneConditional(*gp, Eigen::Vector3d(0.0, bad, 0.0), {0}, Precision::Single),
                     std::invalid_argument);
        SceneConditional scene(*gp, Eigen::Vector3d::Zero(), {0}, Precision::Single);
        Eigen::VectorXd mean, variance;
        EXPECT_THROW(scene.predict(Eigen::MatrixXd::Constant(1, 3, bad), mean, variance),
                     std::invalid_argument);
    }
}

TEST(GaussianProcess, aRowAtTenToTheTwoHundredChangesNothingElsewhere)
{
    const Data plain = dataOf(Kind::Plain, 20, 1.0, 0.3, 0.1);
    Data far = plain;
    far.X.conservativeResize(21, Eigen::NoChange);
    far.X.row(20) << 1e200, 0.0, 0.0;
    far.y.conservativeResize(21);
    far.y[20] = 5.0;
    const Normal expected = built(plain)->predict(Eigen::Vector3d(0.1, 0.2, 0.3));
    const Normal got = built(far)->predict(Eigen::Vector3d(0.1, 0.2, 0.3));
    EXPECT_NEAR(got.mean, expected.mean, 1e-14);
    EXPECT_NEAR(got.variance, expected.variance, 1e-14);
}

TEST(GaussianProcess, withHugeOutputsScalesThemOrRefuses)
{
    Data data = dataOf(Kind::Plain, 20, 1.0, 0.3, 0.1);
    const Eigen::Vector3d x(0.1, 0.2, 0.3);
    const double expected = built(data)->predict(x).mean;
    data.y *= 1e200;
    EXPECT_NEAR(built(data)->predict(x).mean, 1e200 * expected, 1e188);
    data.y *= 1e107;
    EXPECT_FALSE(built(data));
    EXPECT_THROW((void)negativeLogLikelihood(data.X, data.y, data.hyper), std::invalid_argument);
}

TEST(Likelihood, ofDoubledRowsWithoutNoiseIsRefused)
{
    const Data data = dataOf(Kind::DoubledRows, 40, 1.0, 0.3, 1e-12);
    EXPECT_THROW((void)negativeLogLikelihood(data.X, data.y, data.hyper), std::invalid_argument);
}

TEST(GaussianProcess, isBuiltOnlyIfEveryPollReturns)
{
    struct Stop {};
    const Data data = dataOf(Kind::Plain, 200, 1.0, 0.3, 0.1);
    int polls = 0;
    const GaussianProcess whole(data.X, data.y, data.hyper, 0.0, [&] { ++polls; });
    EXPECT_GT(polls, 10);
    for (int last = 1; last <= polls; last += 7) {
        int left = last;
        EXPECT_THROW(GaussianProcess(data.X, data.y, data.hyper, 0.0,
                                     [&] {
                                         if (--left == 0) throw Stop{};
                                     }),
                     Stop);
    }
}

struct ManyRows {
    const char* name;
    Kind kind;
    double length, noise;
    int rows;  ///< by default: as many as a trained model has, where that is quick
};

class Sizes : public testing::TestWithParam<ManyRows> {};

/// TERRATACT_ROWS=5600 takes some minutes for each (the reference) and 1.2 GB.
TEST_P(Sizes, ofAModelAreAnsweredAsInLongDouble)
{
    const char* const wanted = std::getenv("TERRATACT_ROWS");
    const int U = wanted ? std::stoi(wanted) : GetParam().rows;
    const Data data = dataOf(GetParam().kind, U, GetParam().length, 0.3, GetParam().noise);
    const auto gp = built(data);
    ASSERT_TRUE(gp);
    worstShare = 0.0;
    expectRight(data, *gp, std::to_string(U) + " rows");
    std::cout << U << " rows, jitter " << gp->jitter() << ", rcond " << gp->rcond() << ", bound "
              << gp->errorBound() << ", of which " << worstShare << '\n';
}

INSTANTIATE_TEST_SUITE_P(ManyRows, Sizes,
                         testing::Values(ManyRows{"plain", Kind::Plain, 1.0, 0.05, 1400},
                                         ManyRows{"doubledRows", Kind::DoubledRows, 1.0, 0.0, 1400},
                                         ManyRows{"collinear", Kind::Collinear, 1.0, 0.0, 300},
                                         ManyRows{"hugeLengths", Kind::Plain, 1e4, 0.0, 300},
                                         ManyRows{"tinyLengths", Kind::Plain, 1e-4, 0.0, 300},
                                         ManyRows{"tinyNoise", Kind::Plain, 1.0, 1e-6, 300},
                                         ManyRows{"oneRowOnly", Kind::OneRowOnly, 1.0, 1e-9, 300}),
                         [](const auto& size) { return std::string(size.param.name); });

}  // namespace
}  // namespace terratact
