#include "core/learn/covariance_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/learn/gaussian_process.h"

namespace terratact {
namespace {

AlignedDoubles random(std::size_t size, std::mt19937_64& rng)
{
    std::normal_distribution<double> normal;
    AlignedDoubles values(size);
    for (std::size_t k = 0; k < size; ++k) values.data()[k] = normal(rng);
    return values;
}

/// Every variant that this machine runs, in sizes that do and do not fill its registers.
class CovarianceKernelsOf : public testing::TestWithParam<int> {};

TEST_P(CovarianceKernelsOf, allInstructionSetsGiveTheFormulasCovariances)
{
    const int C = GetParam();
    constexpr int U = 37;
    constexpr int m = 5;
    std::mt19937_64 rng(1);
    const AlignedDoubles X = random(U * m, rng);
    AlignedDoubles weight = random(U, rng);
    const AlignedDoubles Z = random(static_cast<std::size_t>(m * C), rng);
    for (int u = 0; u < U; ++u)
        weight.data()[u] = -std::abs(weight.data()[u]) * (u == 3 ? 1e4 : 1.0);
    int count = 0;
    const auto* kernels = availableCovarianceKernels(count);
    ASSERT_GE(count, 1);
    for (int v = 0; v < count; ++v) {
        AlignedDoubles K(static_cast<std::size_t>(U * C));
        kernels[v]->covariances(X.data(), weight.data(), Z.data(), U, m, C, 2.5, K.data());
        for (int u = 0; u < U; ++u)
            for (int c = 0; c < C; ++c) {
                double exponent = weight.data()[u];
                for (int j = 0; j < m; ++j)
                    exponent -= 0.5 * std::pow(X.data()[u * m + j] - Z.data()[j * C + c], 2);
                const double expected = 2.5 * std::exp(exponent);
                EXPECT_NEAR(K.data()[u * C + c], expected, 4e-14 * expected + 1e-290)
                    << kernels[v]->name << " row " << u << " column " << c;
            }
    }
}

TEST_P(CovarianceKernelsOf, allInstructionSetsGiveTheSameSumsOfSquares)
{
    const int C = GetParam();
    constexpr int U = 64;
    std::mt19937_64 rng(2);
    std::size_t size = 0;
    for (int first = 0; first < U; first += kPanelRows)
        size += static_cast<std::size_t>(kPanelRows * (first + kPanelRows));
    const AlignedDoubles panels = random(size, rng);
    const AlignedDoubles K = random(static_cast<std::size_t>(U * C), rng);
    int count = 0;
    const auto* kernels = availableCovarianceKernels(count);
    for (int v = 0; v < count; ++v) {
        AlignedDoubles sums(static_cast<std::size_t>(C));
        kernels[v]->sumsOfSquares(panels.data(), K.data(), U, C, sums.data());
        for (int c = 0; c < C; ++c) {
            double expected = 0.0;
            const double* panel = panels.data();
            for (int first = 0; first < U; first += kPanelRows) {
                for (int r = 0; r < kPanelRows; ++r) {
                    double product = 0.0;
                    for (int j = 0; j < first + kPanelRows; ++j)
                        product += panel[j * kPanelRows + r] * K.data()[j * C + c];
                    expected += product * product;
                }
                panel += kPanelRows * (first + kPanelRows);
            }
            EXPECT_NEAR(sums.data()[c], expected, 1e-12 * expected)
                << kernels[v]->name << " column " << c;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Columns, CovarianceKernelsOf, testing::Values(8, 16, 24, 64));

}  // namespace
}  // namespace terratact
