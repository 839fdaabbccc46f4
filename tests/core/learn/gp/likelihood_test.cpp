#include "core/learn/gp/likelihood.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <Eigen/Dense>
#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include "core/learn/gp/gaussian_process.h"
#include "tests/support/extreme_data.h"
#include "tests/support/process_data.h"

namespace terratact {
namespace {

TEST(Likelihood, isTheLogDensityOfTheOutputs)
{
    for (const int U : {1, 40, 97, 230}) {
        const ProcessData data = someData(U, 3);
        const Eigen::MatrixXd K = covariance(data);
        const Eigen::LLT<Eigen::MatrixXd> llt(K);
        const Eigen::MatrixXd L = llt.matrixL();
        const double expected = 0.5 * data.y.dot(llt.solve(data.y))
                              + L.diagonal().array().log().sum()
                              + 0.5 * U * std::log(2.0 * std::numbers::pi);
        EXPECT_NEAR(negativeLogLikelihood(data.X, data.y, data.hyper).negativeLog, expected,
                    1e-10 * std::abs(expected))
            << U << " rows";
    }
}

TEST(Likelihood, gradientIsTheSlopeOfTheValue)
{
    const ProcessData data = someData(210, 4);  // three panels
    const Likelihood at = negativeLogLikelihood(data.X, data.y, data.hyper);
    ASSERT_EQ(at.gradient.size(), 6);
    constexpr double h = 1e-5;
    for (Eigen::Index k = 0; k < 6; ++k) {
        const auto shifted = [&](double by) {
            Hyperparameters p = data.hyper;
            double& value = k < 4 ? p.lengthScale[k] : (k == 4 ? p.signalSd : p.noiseSd);
            value *= std::exp(by);
            return negativeLogLikelihood(data.X, data.y, p).negativeLog;
        };
        const double slope = (shifted(h) - shifted(-h)) / (2.0 * h);
        EXPECT_NEAR(at.gradient[k], slope, 1e-6 * (1.0 + std::abs(slope))) << "parameter " << k;
    }
}

TEST(Likelihood, gradientKeepsItsDigitsWhereLengthScalesAreLong)
{
    ProcessData data = someData(110, 2);  // more than one panel
    data.hyper.lengthScale << 1e7, 0.8;
    const Likelihood at = negativeLogLikelihood(data.X, data.y, data.hyper);
    // ∂/∂log ℓ = ½ Σ G_ij (x_i − x_j)² / ℓ²: all of it tiny.
    EXPECT_GT(std::abs(at.gradient[0]), 0.0);
    EXPECT_LT(std::abs(at.gradient[0]), 1e-6);
    ProcessData ten = data;
    ten.hyper.lengthScale[0] = 1e6;
    const double larger = negativeLogLikelihood(ten.X, ten.y, ten.hyper).gradient[0];
    EXPECT_NEAR(larger / at.gradient[0], 100.0, 1e-6);
}

TEST(Likelihood, tinyLengthScalesGiveIndependentOutputs)
{
    ProcessData data = someData(30, 2);
    data.hyper.lengthScale.setConstant(1e-8);
    const double variance = 0.81 + 0.0225;
    const Likelihood l = negativeLogLikelihood(data.X, data.y, data.hyper);
    const double each = 0.5 * std::log(2.0 * std::numbers::pi * variance);
    EXPECT_NEAR(l.negativeLog, 30.0 * each + 0.5 * data.y.squaredNorm() / variance, 1e-9);
}

TEST(Likelihood, refusesWhatHasNone)
{
    ProcessData data = someData(20, 2);
    EXPECT_THROW((void)negativeLogLikelihood(data.X, data.y.head(19), data.hyper),
                 std::invalid_argument);
    ProcessData doubled = data;
    doubled.X.row(1) = doubled.X.row(0);
    doubled.hyper.noiseSd = 0.0;
    EXPECT_THROW((void)negativeLogLikelihood(doubled.X, doubled.y, doubled.hyper),
                 std::invalid_argument);
    ProcessData alike =
        someData(5, 2);  // the rows hardly differ: the last squared pivots are 3e-15
    alike.hyper.lengthScale.setConstant(1e9);
    alike.hyper.signalSd = 1.0;
    alike.hyper.noiseSd = 5e-8;
    EXPECT_THROW((void)negativeLogLikelihood(alike.X, alike.y, alike.hyper), std::invalid_argument);
    ProcessData large = data;
    large.y.setConstant(1e200);
    EXPECT_THROW((void)negativeLogLikelihood(large.X, large.y, large.hyper), std::invalid_argument);
    ProcessData far = data;
    far.X(3, 0) = 1e200;
    far.hyper.lengthScale[0] = 1e-200;
    EXPECT_THROW((void)negativeLogLikelihood(far.X, far.y, far.hyper), std::invalid_argument);
}

/// The header's formulas in long double.
struct LongLikelihood {
    double negativeLog = 0.0;
    Eigen::VectorXd gradient;
    double size = 0.0;   ///< U + yᵀ α
    double rcond = 0.0;  ///< of K
};

LongLikelihood inLongDouble(const ExtremeData& data)
{
    const Hyperparameters& hyper = data.hyper;
    const Eigen::Index U = data.X.rows(), d = data.X.cols();
    const LongMatrix signal = covarianceOf(data.X, data.X, hyper);
    LongMatrix K = signal;
    K.diagonal().array() += squareOf(hyper.noiseSd);
    const Eigen::LLT<LongMatrix> factor(K);
    const LongMatrix inverse = inverseOf(factor);
    const LongVector alpha = inverse * data.y.cast<Long>();
    const LongMatrix W = inverse - alpha * alpha.transpose();
    const Long quadratic = data.y.cast<Long>().dot(alpha);
    const LongMatrix L = factor.matrixL();
    LongLikelihood l;
    l.negativeLog = static_cast<double>(0.5L * quadratic + L.diagonal().array().log().sum()
                                        + 0.5L * static_cast<Long>(U)
                                              * std::log(2.0L * std::numbers::pi_v<Long>));
    l.gradient.resize(d + 2);
    for (Eigen::Index k = 0; k < d; ++k) {
        const LongVector z = data.X.col(k).cast<Long>() / static_cast<Long>(hyper.lengthScale[k]);
        const LongMatrix square = (z.replicate(1, U) - z.transpose().replicate(U, 1)).cwiseAbs2();
        l.gradient[k] =
            static_cast<double>(0.5L * W.cwiseProduct(signal).cwiseProduct(square).sum());
    }
    l.gradient[d] = static_cast<double>(W.cwiseProduct(signal).sum());
    l.gradient[d + 1] = static_cast<double>(squareOf(hyper.noiseSd) * W.trace());
    l.size = static_cast<double>(static_cast<Long>(U) + quadratic);
    l.rcond = rcondOf(K);
    return l;
}

TEST(Likelihood, equalsLongDoubleOrIsRefusedAtExtremes)
{
    int right = 0, refused = 0, exact = 0;
    double worst = 0.0;
    const auto check = [&](const ExtremeData& data, const std::string& what) {
        const LongLikelihood expected = inLongDouble(data);
        Likelihood got;
        try {
            got = negativeLogLikelihood(data.X, data.y, data.hyper);
        } catch (const std::invalid_argument& why) {
            EXPECT_GT(std::string(why.what()).size(), 30U);
            EXPECT_LT(expected.rcond, 1e-12) << what;  // refused for this alone
            ++refused;
            return;
        }
        ++right;
        const double share = std::min(errorBoundAt(expected.rcond), 1e-2);
        exact += share == 1e-9;
        const double bound = share * expected.size;
        EXPECT_NEAR(got.negativeLog, expected.negativeLog, bound) << what;
        for (Eigen::Index k = 0; k < expected.gradient.size(); ++k) {
            EXPECT_NEAR(got.gradient[k], expected.gradient[k], bound) << what << ", " << k;
            if (share > 1e-9)
                worst = std::max(worst, std::abs(got.gradient[k] - expected.gradient[k]) / bound);
        }
    };
    for (const Kind kind : kKinds)
        for (const int U : {1, 2, 24}) forEveryScale(kind, U, check);
    EXPECT_GT(right, 400);
    EXPECT_GT(exact, 300);
    EXPECT_GT(refused, 50);
    std::cout << right << " right, " << exact << " of them to 1e-9, " << refused
              << " refused; errors up to " << worst
              << " of the bound where the condition decides\n";
}

/// Kilobytes from /proc/self/status.
long status(const std::string& key)
{
    std::ifstream file("/proc/self/status");
    std::string word;
    long value = -1;
    while (file >> word)
        if (word == key) file >> value;
    return value;
}

TEST(Likelihood, needsLessThanFourTimesItsRowsSquared)
{
    const ProcessData data = someData(1200, 22);
    (void)negativeLogLikelihood(data.X.topRows(100), data.y.head(100), data.hyper);
    if (!(std::ofstream("/proc/self/clear_refs") << "5" << std::flush))
        GTEST_SKIP() << "the kernel does not reset a process's largest size";
    // Large blocks get new pages: memory that other tests have freed would be used again and hide the peak.
    mallopt(M_MMAP_THRESHOLD, 128 << 10);
    const long before = status("VmRSS:");
    (void)negativeLogLikelihood(data.X, data.y, data.hyper);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that glibc chooses itself
    const double doubles = static_cast<double>(status("VmHWM:") - before) * 128.0;
    EXPECT_LT(doubles, 4.0 * 1200.0 * 1200.0);
    EXPECT_GT(doubles, 0.4 * 1200.0 * 1200.0);  // the measurement worked
}

TEST(Likelihood, pollsOftenAndRethrows)
{
    struct Stop {};
    const ProcessData data = someData(400, 3);
    int polls = 0;
    (void)negativeLogLikelihood(data.X, data.y, data.hyper, [&] { ++polls; });
    EXPECT_GT(polls, 50);
    for (int last = 1; last <= polls; last += 5) {
        int left = last;
        EXPECT_THROW((void)negativeLogLikelihood(data.X, data.y, data.hyper,
                                                 [&] {
                                                     if (--left == 0) throw Stop{};
                                                 }),
                     Stop);
    }
}

TEST(Likelihood, countsTheVarianceOfEachRow)
{
    const ProcessData data = someData(40, 3);
    const Eigen::VectorXd variance = Eigen::VectorXd::LinSpaced(40, 0.0, 0.3);
    Eigen::MatrixXd K = covariance(data);
    K.diagonal() += variance;
    const Eigen::LLT<Eigen::MatrixXd> llt(K);
    const double expected = 0.5 * data.y.dot(llt.solve(data.y))
                          + llt.matrixLLT().diagonal().array().log().sum()
                          + 20.0 * std::log(2.0 * std::numbers::pi);
    const auto at = [&](double logNoise) {
        Hyperparameters hyper = data.hyper;
        hyper.noiseSd = std::exp(logNoise);
        return negativeLogLikelihood(data.X, data.y, hyper, {}, variance);
    };
    const double logNoise = std::log(data.hyper.noiseSd);
    EXPECT_NEAR(at(logNoise).negativeLog, expected, 1e-8);
    const double slope = (at(logNoise + 1e-5).negativeLog - at(logNoise - 1e-5).negativeLog) / 2e-5;
    EXPECT_NEAR(at(logNoise).gradient[4], slope, 1e-4);
}

}  // namespace
}  // namespace terratact
