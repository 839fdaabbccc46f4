// Results are right or refused with a text: no NaN, and no confident wrong number.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/infer/estimate/quality_preset.h"
#include "core/learn/gp/gaussian_process.h"
#include "core/learn/gp/likelihood.h"
#include "core/learn/gp/scene_conditional.h"
#include "core/learn/gp/sparse_process.h"
#include "tests/support/extreme_data.h"

namespace terratact {
namespace {

/// The textbook formulas with 64 bits of mantissa, using the model's jitter.
class Reference {
public:
    Reference(const ExtremeData& data, double jitter)
        : data_(data), prior_(squareOf(data.hyper.signalSd) + squareOf(data.hyper.noiseSd))
    {
        LongMatrix K = covarianceOf(data.X, data.X, data.hyper);
        K.diagonal().array() += squareOf(data.hyper.noiseSd) + jitter * prior_;
        factor_.compute(K);
        alpha_ = factor_.solve(data.y.cast<Long>());
    }

    Normal predict(const Eigen::VectorXd& x) const
    {
        const LongVector k = covarianceWith(data_.X, x, data_.hyper);
        const LongVector v = factor_.matrixL().solve(k);
        return {static_cast<double>(k.dot(alpha_)), static_cast<double>(prior_ - v.squaredNorm())};
    }

private:
    const ExtremeData& data_;
    Long prior_;
    Eigen::LLT<LongMatrix> factor_;
    LongVector alpha_;
};

/// The formulas of core/learn/gp/sparse_process.h with the rows that it chooses. With K_mm = L Lᵀ
/// and V = L⁻¹ K_mn it is A = L (1 + V Λ⁻¹ Vᵀ) Lᵀ.
class SparseReference {
public:
    SparseReference(const ExtremeData& data, int count, double jitter)
        : data_(data),
          Z_(data.X(sparseProcess(data.X, data.y, count, data.hyper).inducing, Eigen::all)),
          prior_(squareOf(data.hyper.signalSd) + squareOf(data.hyper.noiseSd)),
          outer_(covarianceOf(Z_, Z_, data.hyper))
    {
        LongMatrix V = outer_.matrixL().solve(covarianceOf(Z_, data.X, data.hyper));
        const LongVector unexplained =
            (squareOf(data.hyper.signalSd) - V.colwise().squaredNorm().transpose().array())
                .max(0.0L);
        const LongVector lambda =
            unexplained.array() + squareOf(data.hyper.noiseSd) + jitter * prior_;
        V.array().rowwise() /= lambda.transpose().array().sqrt();
        inner_.compute(LongMatrix::Identity(V.rows(), V.rows()) + V * V.transpose());
        coefficients_ =
            inner_.solve(V * (data.y.cast<Long>().array() / lambda.array().sqrt()).matrix());
    }

    Normal predict(const Eigen::VectorXd& x) const
    {
        const LongVector v = outer_.matrixL().solve(covarianceWith(Z_, x, data_.hyper));
        return {static_cast<double>(v.dot(coefficients_)),
                static_cast<double>(prior_ - v.squaredNorm() + v.dot(inner_.solve(v)))};
    }

private:
    const ExtremeData& data_;
    Eigen::MatrixXd Z_;
    Long prior_;
    Eigen::LLT<LongMatrix> outer_, inner_;
    LongVector coefficients_;
};

/// Largest error so far that the condition number decides, as a share of the header's bound.
double worstShare = 0.0;

void note(double error, double bound)
{
    if (bound > 1e-9) worstShare = std::max(worstShare, error / bound);
}

/// Returns true if its variances in single precision pass through fewer rows than it has.
bool isReduced(const GaussianProcess& gp)
{
    return gp.usable(Precision::Single) == Precision::Single && gp.varianceRows() < gp.rows();
}

/// Compares the variance in single precision, as a sampler asks for it, with the one in double.
/// size: of the outputs.
void expectRightInSingle(const GaussianProcess& gp, const Eigen::VectorXd& x, double size,
                         const std::string& what)
{
    Eigen::VectorXd mean, variance, exactMean, exactVariance;
    SceneConditional(gp, x, {0}, Precision::Single).predict(x.head(1), mean, variance);
    SceneConditional(gp, x, {0}, Precision::Double).predict(x.head(1), exactMean, exactVariance);
    const double noise2 = std::pow(gp.hyperparameters().noiseSd, 2);
    double allowed = 0.0;
    if (!isReduced(gp)) {
        EXPECT_EQ(mean[0], exactMean[0]) << what;
        if (gp.usable(Precision::Single) == Precision::Single)
            allowed = std::min(1e-2 * noise2, kSingleErrorElsewhere * gp.singleError());
    } else {
        EXPECT_NEAR(mean[0], exactMean[0], gp.errorBound() * size) << what;
        allowed = 0.1 * kSingleVarianceError * exactVariance[0];  // data without surprises
    }
    EXPECT_NEAR(variance[0], exactVariance[0], allowed) << what << ", single";
    EXPECT_GE(variance[0], noise2) << what << ", single";
}

template <class SomeReference>
void expectRight(const ExtremeData& data, const GaussianProcess& gp, const SomeReference& reference,
                 const std::string& what)
{
    EXPECT_LE(gp.errorBound(), 1.0001e-2) << what;
    const double noise2 = std::pow(data.hyper.noiseSd, 2);
    const double prior = std::pow(data.hyper.signalSd, 2) + noise2;
    const double size = data.y.cwiseAbs().maxCoeff();
    Eigen::VectorXd beside = data.X.row(0).transpose();
    beside[0] += 0.4;
    for (const Eigen::VectorXd& x :
         {Eigen::VectorXd(data.X.row(0)), beside, Eigen::VectorXd(Eigen::Vector3d(50.0, -9.0, 0.0)),
          Eigen::VectorXd(Eigen::Vector3d(1e200, 0.0, -1e308))}) {
        const Normal got = gp.predict(x);
        const Normal expected = reference.predict(x);
        ASSERT_TRUE(std::isfinite(got.mean) && std::isfinite(got.variance)) << what;
        EXPECT_NEAR(got.mean, expected.mean, std::min(gp.errorBound() * size, gp.meanErrorBound()))
            << what;
        EXPECT_NEAR(got.variance, expected.variance, gp.errorBound() * prior) << what;
        note(std::abs(got.mean - expected.mean) / size, gp.errorBound());
        note(std::abs(got.variance - expected.variance) / prior, gp.errorBound());
        EXPECT_GT(got.variance, 0.0) << what;
        EXPECT_GE(got.variance, noise2) << what;
        EXPECT_LE(got.variance, prior * (1.0 + 1e-12)) << what;
        expectRightInSingle(gp, x, size, what);
    }
}

std::unique_ptr<GaussianProcess> builtThrough(int inducing, const ExtremeData& data)
{
    try {
        return GaussianProcess::sparse(data.X, data.y, inducing, data.hyper, 0.0);
    } catch (const std::invalid_argument& refused) {
        EXPECT_GT(std::string(refused.what()).size(), 30U);
        return nullptr;
    }
}

std::unique_ptr<GaussianProcess> built(const ExtremeData& data)
{
    return builtThrough(static_cast<int>(data.X.rows()), data);
}

/// Counts of the answers of all these processes.
struct Tally {
    int answered = 0, mended = 0, single = 0, reduced = 0, refused = 0;

    /// Checks one process that must equal long double.
    template <class SomeReference>
    void add(const ExtremeData& data, const GaussianProcess& gp, const SomeReference& reference,
             const std::string& what)
    {
        ++answered;
        mended += gp.jitter() > 0.0;
        single += gp.usable(Precision::Single) == Precision::Single;
        reduced += isReduced(gp);
        EXPECT_LE(gp.jitter(), 1e-6) << what;
        EXPECT_GE(gp.rcond(), kMinRcond) << what;
        if (data.hyper.noiseSd >= 1e-3 * data.hyper.signalSd) {
            EXPECT_EQ(gp.jitter(), 0.0) << what;
        }
        expectRight(data, gp, reference, what);
    }

    void judge() const
    {
        EXPECT_EQ(refused, 0);  // with a jitter each of these can be answered
        EXPECT_GT(answered, 100);
        EXPECT_GT(single, 30);
        std::cout << answered << " answered, " << mended << " of them with a jitter, " << single
                  << " in single precision, " << reduced
                  << " of these through fewer rows; errors up to " << worstShare
                  << " of the bound where the condition decides\n";
    }
};

class Extremes : public testing::TestWithParam<Kind> {};

TEST_P(Extremes, equalLongDoubleOrAreRefused)
{
    Tally tally;
    worstShare = 0.0;
    for (const int U : {1, 2, 40})
        forEveryScale(GetParam(), U, [&tally](const ExtremeData& data, const std::string& what) {
            if (const auto gp = built(data))
                tally.add(data, *gp, Reference(data, gp->jitter()), what);
            else
                ++tally.refused;
        });
    tally.judge();
    EXPECT_GT(tally.reduced, 2);
}

TEST_P(Extremes, throughFewRowsEqualLongDoubleOrAreRefused)
{
    Tally tally;
    worstShare = 0.0;
    for (const int U : {2, 40}) {
        const int few = U < 40 ? 1 : 12;
        forEveryScale(GetParam(), U,
                      [&tally, few](const ExtremeData& data, const std::string& what) {
                          if (const auto gp = builtThrough(few, data))
                              tally.add(data, *gp, SparseReference(data, few, gp->jitter()), what);
                          else
                              ++tally.refused;
                      });
    }
    tally.judge();
}

TEST_P(Extremes, equalLongDoubleWithOneScalePerInput)
{
    Tally tally;
    for (const Eigen::Vector3d& lengths :
         {Eigen::Vector3d(1e-8, 1.0, 1e8), Eigen::Vector3d(1.0, 1e8, 1e-8),
          Eigen::Vector3d(1e8, 1e-8, 1.0), Eigen::Vector3d(1e8, 1e8, 1e-3)})
        for (const double signal : {1e-12, 0.3, 1e6})
            for (const double noise : {0.0, 1e-3}) {
                ExtremeData data = dataOf(GetParam(), 40, 1.0, signal, noise);
                data.hyper.lengthScale = lengths;
                std::ostringstream what;
                what << "lengths " << lengths.transpose() << ", sf " << signal << ", sn " << noise;
                const auto gp = built(data);
                ASSERT_TRUE(gp) << what.str();
                tally.add(data, *gp, Reference(data, gp->jitter()), what.str());
            }
    EXPECT_EQ(tally.answered, 24);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Extremes, testing::ValuesIn(kKinds));

TEST(Jitter, isTheLeastThatSufficesForRepeatedRows)
{
    const auto gp = built(dataOf(Kind::DoubledRows, 20, 1.0, 0.3, 0.0));
    EXPECT_EQ(gp->jitter(), 1e-10);
    EXPECT_EQ(built(dataOf(Kind::DoubledRows, 20, 1.0, 0.3, 0.01))->jitter(), 0.0);
}

TEST(GaussianProcess, withoutAnyScaleIsRefused)
{
    for (const int rows : {5, 20}) {
        const auto refuses = [rows](double length, double signal, double noise) {
            return !builtThrough(rows, dataOf(Kind::Plain, 20, length, signal, noise));
        };
        EXPECT_TRUE(refuses(1.0, 1e-200, 0.0)) << rows;  // its square is 0
        EXPECT_TRUE(refuses(1.0, 1e200, 0.1)) << rows;   // its square is infinite
        EXPECT_TRUE(refuses(1e-310, 0.3, 0.1)) << rows;  // inputs overflow
    }
}

TEST(GaussianProcess, withOneValueThatIsNotANumberIsRefused)
{
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        ExtremeData data = dataOf(Kind::Plain, 20, 1.0, 0.3, 0.1);
        data.X(7, 1) = bad;
        EXPECT_FALSE(built(data));
        EXPECT_FALSE(builtThrough(5, data));
        EXPECT_THROW((void)negativeLogLikelihood(data.X, data.y, data.hyper),
                     std::invalid_argument);
        data = dataOf(Kind::Plain, 20, 1.0, 0.3, 0.1);
        data.y[3] = bad;
        EXPECT_FALSE(built(data));
        EXPECT_FALSE(builtThrough(5, data));
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

/// The rows are 1e-8 length scales apart around 1: scaled inputs would have rounding errors of 1e-8
/// of a length scale.
TEST(GaussianProcess, isRightForRowsTinyLengthScalesApart)
{
    ExtremeData data = dataOf(Kind::Plain, 40, 1e-8, 0.3, 0.1);
    data.X = (1.0 + 1e-8 * data.X.array()).matrix();
    const GaussianProcess gp(data.X, data.y, data.hyper, 0.0);
    EXPECT_EQ(gp.errorBound(), 1e-9);
    const Reference reference(data, gp.jitter());
    for (const double beside : {0.0, 0.7e-8, -1.3e-8}) {
        const Eigen::Vector3d x = data.X.row(3).transpose().array() + beside;
        const Normal expected = reference.predict(x);
        EXPECT_NEAR(gp.predict(x).mean, expected.mean, 1e-12);
        EXPECT_NEAR(gp.predict(x).variance, expected.variance, 1e-12);
        EXPECT_GT(std::abs(expected.mean), 0.01);
    }
    const double likelihood = negativeLogLikelihood(data.X, data.y, data.hyper).negativeLog;
    data.X = ((data.X.array() - 1.0) * std::ldexp(1.0, 27)).matrix();  // exact
    data.hyper.lengthScale *= std::ldexp(1.0, 27);
    EXPECT_NEAR(negativeLogLikelihood(data.X, data.y, data.hyper).negativeLog, likelihood, 1e-10);
}

/// Neighbours contradict each other: the weights of every mean cancel.
TEST(GaussianProcess, keepsItsBoundForRoughOutputs)
{
    double worst = 0.0;
    for (const double noise : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5})
        for (const double length : {0.05, 0.3, 2.0}) {
            ExtremeData data = dataOf(Kind::Plain, 60, length, 1.0, noise);
            for (Eigen::Index u = 0; u < 60; ++u) {
                data.X.row(u) << 0.02 * static_cast<double>(u), 0.0, 0.0;
                data.y[u] = u % 2 == 0 ? 1.0 : -1.0;
            }
            const GaussianProcess gp(data.X, data.y, data.hyper, 0.0);
            const Reference reference(data, gp.jitter());
            for (const double beside : {0.0, 1.0, 2.0, 3.0}) {
                const Eigen::Vector3d x(1.2 + beside * length, 0.0, 0.0);
                const double error = std::abs(gp.predict(x).mean - reference.predict(x).mean);
                EXPECT_LE(error, gp.meanErrorBound()) << noise << ' ' << length << ' ' << beside;
                worst = std::max(worst, error / gp.errorBound());
            }
        }
    EXPECT_GT(worst, 1.0) << "max |y| alone would not have been enough";
}

TEST(GaussianProcess, rowAt1e200ChangesNothingElsewhere)
{
    const ExtremeData plain = dataOf(Kind::Plain, 20, 1.0, 0.3, 0.1);
    const ExtremeData far = withFarRow(plain);
    for (const int rows : {12, 20}) {  // the distant row is one more
        const Normal expected = builtThrough(rows, plain)->predict(Eigen::Vector3d(0.1, 0.2, 0.3));
        const Normal got = builtThrough(rows + 1, far)->predict(Eigen::Vector3d(0.1, 0.2, 0.3));
        EXPECT_NEAR(got.mean, expected.mean, 1e-14) << rows;
        EXPECT_NEAR(got.variance, expected.variance, 1e-14) << rows;
    }
}

TEST(GaussianProcess, withHugeOutputsScalesThemOrRefuses)
{
    const Eigen::Vector3d x(0.1, 0.2, 0.3);
    ExtremeData data;
    for (const int rows : {5, 20}) {
        data = dataOf(Kind::Plain, 20, 1.0, 0.3, 0.1);
        const double expected = builtThrough(rows, data)->predict(x).mean;
        data.y *= 1e200;
        EXPECT_NEAR(builtThrough(rows, data)->predict(x).mean, 1e200 * expected, 1e188) << rows;
        data.y *= 1e107;
        EXPECT_FALSE(builtThrough(rows, data)) << rows;
    }
    EXPECT_THROW((void)negativeLogLikelihood(data.X, data.y, data.hyper), std::invalid_argument);
}

TEST(Likelihood, refusesRepeatedRowsWithoutNoise)
{
    const ExtremeData data = dataOf(Kind::DoubledRows, 40, 1.0, 0.3, 1e-12);
    EXPECT_THROW((void)negativeLogLikelihood(data.X, data.y, data.hyper), std::invalid_argument);
}

TEST(GaussianProcess, isBuiltOnlyIfEveryPollReturns)
{
    struct Stop {};
    const ExtremeData data = dataOf(Kind::Plain, 200, 1.0, 0.3, 0.1);
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

void print(const GaussianProcess& gp, int U)
{
    std::cout << U << " rows, jitter " << gp.jitter() << ", rcond " << gp.rcond() << ", bound "
              << gp.errorBound() << ", of which " << worstShare << '\n';
}

/// TERRATACT_ROWS=5600 takes some minutes for each reference, and 1.2 GB.
TEST_P(Sizes, ofAModelEqualLongDouble)
{
    const int U = manyRows(GetParam().rows);
    const ExtremeData data = dataOf(GetParam().kind, U, GetParam().length, 0.3, GetParam().noise);
    const auto gp = built(data);
    ASSERT_TRUE(gp);
    worstShare = 0.0;
    expectRight(data, *gp, Reference(data, gp->jitter()), std::to_string(U) + " rows");
    print(*gp, U);
}

TEST_P(Sizes, throughTheRowsOfAPresetEqualLongDouble)
{
    const int few = withPreset({}, QualityPreset::Fast).inducing;
    const int U = std::max(manyRows(GetParam().rows), 1400);
    const ExtremeData data = dataOf(GetParam().kind, U, GetParam().length, 0.3, GetParam().noise);
    const auto gp = builtThrough(few, data);
    ASSERT_TRUE(gp);
    worstShare = 0.0;
    expectRight(data, *gp, SparseReference(data, few, gp->jitter()), std::to_string(U) + " rows");
    print(*gp, U);
}

INSTANTIATE_TEST_SUITE_P(ManyRows, Sizes,
                         testing::Values(ManyRows{"plain", Kind::Plain, 1.0, 0.05, 1400},
                                         ManyRows{"doubledRows", Kind::DoubledRows, 1.0, 0.0, 1400},
                                         ManyRows{"collinear", Kind::Collinear, 1.0, 0.0, 1400},
                                         ManyRows{"constantColumn", Kind::ConstantColumn, 1.0, 1e-3,
                                                  1400},
                                         ManyRows{"hugeLengths", Kind::Plain, 1e8, 0.0, 300},
                                         ManyRows{"tinyLengths", Kind::Plain, 1e-8, 0.0, 300},
                                         ManyRows{"tinyNoise", Kind::Plain, 1.0, 1e-6, 300},
                                         ManyRows{"oneRowOnly", Kind::OneRowOnly, 1.0, 1e-9, 300}),
                         [](const auto& size) { return std::string(size.param.name); });

}  // namespace
}  // namespace terratact
