#include "core/learn/kernels/symmetric_panels.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/learn/gp/symmetric_eigen.h"
#include "core/learn/kernels/likelihood_kernels.h"

namespace terratact {
namespace {

constexpr int kColumns = SymmetricPanels::kPanelColumns;

AlignedArray<double> random(std::size_t size, std::mt19937_64& rng)
{
    std::normal_distribution<double> normal;
    AlignedArray<double> values(size);
    for (std::size_t k = 0; k < size; ++k) values.data()[k] = normal(rng);
    return values;
}

void set(SymmetricPanels& panels, const Eigen::MatrixXd& A)
{
    for (int u = 0; u < A.rows(); ++u)
        for (int c = 0; c <= u; ++c) panels.row(c / kColumns, u)[c % kColumns] = A(u, c);
}

double entry(const SymmetricPanels& panels, int u, int c)
{
    return panels.row(c / kColumns, u)[c % kColumns];
}

/// Returns a matrix with eigenvalues from 1 down to `least`.
Eigen::MatrixXd positiveDefinite(int n, double least)
{
    std::mt19937_64 rng(3);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd M(n, n);
    for (double& x : M.reshaped()) x = normal(rng);
    const Eigen::MatrixXd Q = symmetricEigen(M + M.transpose()).vectors;
    Eigen::VectorXd values(n);
    for (int k = 0; k < n; ++k) values[k] = n > 1 ? std::pow(least, k / (n - 1.0)) : 1.0;
    const Eigen::MatrixXd A = Q * values.asDiagonal() * Q.transpose();
    return 0.5 * (A + A.transpose());
}

class SymmetricPanelsOf : public testing::TestWithParam<int> {};

TEST_P(SymmetricPanelsOf, holdTheInverseTheSolutionAndTheDeterminant)
{
    const int n = GetParam();
    const Eigen::MatrixXd A = positiveDefinite(n, 1e-3);
    const Eigen::VectorXd y = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
    SymmetricPanels panels(n);
    set(panels, A);
    Eigen::VectorXd alpha = y;
    SymmetricPanels::Factors factors;
    ASSERT_TRUE(panels.invert(alpha, factors));
    const Eigen::LLT<Eigen::MatrixXd> llt(A);
    const Eigen::MatrixXd inverse = llt.solve(Eigen::MatrixXd::Identity(n, n));
    for (int u = 0; u < n; ++u)
        for (int c = 0; c <= u; ++c)
            ASSERT_NEAR(entry(panels, u, c), -inverse(u, c), 1e-11 * inverse(u, u))
                << n << ": " << u << ", " << c;
    EXPECT_LT((alpha - llt.solve(y)).norm(), 1e-11 * alpha.norm());
    const double logDet = 2.0 * llt.matrixLLT().diagonal().array().log().sum();
    EXPECT_NEAR(factors.logDeterminant, logDet, 1e-11 * (1.0 + std::abs(logDet)));
    EXPECT_NEAR(factors.quadratic, y.dot(alpha), 1e-11 * factors.quadratic);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SymmetricPanelsOf,
                         testing::Values(1, 2, 8, 23, 95, 96, 97, 192, 200, 301, 600));

TEST(SymmetricPanels, stayAccurateWhereTheConditionIsBad)
{
    constexpr int n = 250;
    const Eigen::MatrixXd A = positiveDefinite(n, 1e-10);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, 1.0, 2.0);
    SymmetricPanels panels(n);
    set(panels, A);
    Eigen::VectorXd solution = A * x;
    const Eigen::VectorXd y = solution;
    SymmetricPanels::Factors factors;
    ASSERT_TRUE(panels.invert(solution, factors));
    const Eigen::LLT<Eigen::MatrixXd> llt(A);
    // The result is as accurate as Cholesky factors, up to a small factor.
    const double cholesky = (llt.solve(y) - x).norm();
    EXPECT_LT((solution - x).norm(), 20.0 * cholesky + 1e-12);
    EXPECT_NEAR(factors.quadratic, y.dot(x), 1e-9 * factors.quadratic);
}

TEST(SymmetricPanels, refuseWhatIsNotPositiveDefinite)
{
    SymmetricPanels::Factors factors;
    for (const double bad : {-1.0, 0.0, std::nan("")}) {
        SymmetricPanels panels(150);
        set(panels, Eigen::MatrixXd::Identity(150, 150));
        panels.row(1, 120)[120 - kColumns] = bad;
        Eigen::VectorXd y = Eigen::VectorXd::Ones(150);
        EXPECT_FALSE(panels.invert(y, factors)) << bad;
    }
}

TEST(LikelihoodKernels, ofAllInstructionSetsSubtractTheSameProducts)
{
    constexpr int length = 37;
    constexpr long stride = 40 * kGroup;
    std::mt19937_64 rng(1);
    const AlignedArray<double> A = random(stride, rng);
    const AlignedArray<double> B = random(3 * stride, rng);
    const AlignedArray<double> before = random(kGroup * kTileColumns, rng);
    int count = 0;
    const auto* kernels = availableLikelihoodKernels(count);
    ASSERT_GE(count, 1);
    for (int v = 0; v < count; ++v) {
        AlignedArray<double> C(kGroup * kTileColumns);
        std::copy_n(before.data(), kGroup * kTileColumns, C.data());
        kernels[v]->subtractProducts(A.data(), B.data(), stride, length, C.data(), kTileColumns,
                                     kGroup);
        for (int r = 0; r < kGroup; ++r)
            for (int c = 0; c < kTileColumns; ++c) {
                double expected = before.data()[r * kTileColumns + c];
                for (int k = 0; k < length; ++k)
                    expected -= A.data()[k * kGroup + r]
                              * B.data()[c / kGroup * stride + k * kGroup + c % kGroup];
                EXPECT_NEAR(C.data()[r * kTileColumns + c], expected, 1e-12)
                    << kernels[v]->name << ": " << r << ", " << c;
            }
    }
}

TEST(LikelihoodKernels, ofAllInstructionSetsGiveTheSameWeightedSquares)
{
    constexpr int columns = 520;  // more than one block of the kernel
    constexpr int m = 7;
    std::mt19937_64 rng(2);
    const AlignedArray<double> N = random(columns, rng);
    const AlignedArray<double> S = random(columns, rng);
    const AlignedArray<double> alpha = random(columns, rng);
    const AlignedArray<double> Z = random(m * columns, rng);
    const AlignedArray<double> x = random(m, rng);
    int count = 0;
    const auto* kernels = availableLikelihoodKernels(count);
    for (int v = 0; v < count; ++v) {
        AlignedArray<double> sums((m + 1) * kGroup);
        kernels[v]->addWeightedSquares(N.data(), S.data(), 0.7, alpha.data(), columns, x.data(),
                                       Z.data(), columns, m, sums.data());
        for (int d = 0; d <= m; ++d) {
            double expected = 0.0;
            double size = 0.0;
            for (int c = 0; c < columns; ++c) {
                const double g = (-N.data()[c] - 0.7 * alpha.data()[c]) * S.data()[c];
                const double difference = d < m ? x.data()[d] - Z.data()[d * columns + c] : 1.0;
                expected += g * difference * difference;
                size += std::abs(g) * difference * difference;
            }
            double got = 0.0;
            for (int k = 0; k < kGroup; ++k) got += sums.data()[d * kGroup + k];
            EXPECT_NEAR(got, expected, 1e-14 * size) << kernels[v]->name << ": " << d;
        }
    }
}

TEST(SymmetricPanels, asksBeforeEveryHugePage)
{
    constexpr int n = 1400;
    std::size_t asked = 0;
    SymmetricPanels panels(n, [&] { ++asked; });
    std::size_t numbers = 0;  // a panel holds all rows from its own on
    for (int first = 0; first < n; first += kColumns)
        numbers += static_cast<std::size_t>(kColumns * (panels.paddedSize() - first));
    EXPECT_EQ(asked, numbers * sizeof(double) / kHugePage + 1);
}

}  // namespace
}  // namespace terratact
