#include "core/learn/kernels/covariance_kernels.h"
#include "core/learn/kernels/kernel_poll.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "core/learn/kernels/aligned_array.h"

namespace terratact {
namespace {

template <class T>
AlignedArray<T> random(std::size_t size, std::mt19937_64& rng)
{
    std::normal_distribution<double> normal;
    AlignedArray<T> values(size);
    for (std::size_t k = 0; k < size; ++k) values.data()[k] = static_cast<T>(normal(rng));
    return values;
}

std::span<const CovarianceKernels* const> variants()
{
    int count = 0;
    const auto* kernels = availableCovarianceKernels(count);
    return {kernels, static_cast<std::size_t>(count)};
}

/// Arguments of `covariances` for U training rows.
struct Covariances {
    explicit Covariances(int U) : X(random<double>(static_cast<std::size_t>(U) * 5, rng))
    {
        for (int u = 0; u < U; ++u)
            weight.data()[u] = -std::abs(weight.data()[u]) * (u == 3 ? 1e4 : 1.0);
        in = {X.data(), perLength.data(), weight.data(), alpha.data(), U, U, 5, 2.5};
        for (int j = 0; j < 5; ++j) perLength.data()[j] = 0.5 + 0.25 * j;
    }
    double expected(int u, int c) const
    {
        double exponent = weight.data()[u];
        for (int j = 0; j < 5; ++j)
            exponent -=
                0.5
                * std::pow((X.data()[u * 5 + j] - Z.data()[j * kGroup + c]) * perLength.data()[j],
                           2);
        return 2.5 * std::exp(exponent);
    }

    std::mt19937_64 rng{1};
    AlignedArray<double> X;
    AlignedArray<double> perLength{5};
    AlignedArray<double> weight = random<double>(1000, rng);
    AlignedArray<double> alpha = random<double>(1000, rng);
    AlignedArray<double> Z = random<double>(5 * kGroup, rng);
    CovarianceInput in;
};

TEST(CovarianceKernels, giveNoSubnormalNumbers)
{
    Covariances data(200);
    for (int u = 0; u < 200; ++u) data.weight.data()[u] = -4.0 * u;
    for (const CovarianceKernels* kernels : variants()) {
        AlignedArray<double> K(200 * kGroup);
        AlignedArray<float> single(200 * kGroup);
        AlignedArray<double> mean(kGroup);
        kernels->covariances(data.in, data.Z.data(), K.data(), mean.data());
        kernels->covariancesSingle(data.in, data.Z.data(), single.data(), mean.data());
        for (std::size_t k = 0; k < K.size(); ++k) {
            EXPECT_TRUE(std::isnormal(K.data()[k] * K.data()[k])) << kernels->name;
            EXPECT_TRUE(single.data()[k] == 0.0F || std::isnormal(single.data()[k]))
                << kernels->name << " entry " << k;
        }
    }
}

class CovarianceKernelsOf : public testing::TestWithParam<int> {};

TEST_P(CovarianceKernelsOf, equalTheFormulaOnAllInstructionSets)
{
    const int U = GetParam();
    const Covariances data(U);
    for (const CovarianceKernels* kernels : variants()) {
        AlignedArray<double> K(static_cast<std::size_t>(U) * kGroup);
        AlignedArray<float> single(K.size());
        AlignedArray<double> mean(kGroup);
        AlignedArray<double> meanToo(kGroup);
        kernels->covariances(data.in, data.Z.data(), K.data(), mean.data());
        kernels->covariancesSingle(data.in, data.Z.data(), single.data(), meanToo.data());
        for (int c = 0; c < kGroup; ++c) {
            double sum = 0.0;
            for (int u = 0; u < U; ++u) {
                const double expected = data.expected(u, c);
                sum += expected * data.alpha.data()[u];
                EXPECT_NEAR(K.data()[u * kGroup + c], expected, 4e-14 * expected + 1e-120)
                    << kernels->name << " row " << u << " column " << c;
                EXPECT_EQ(single.data()[u * kGroup + c],
                          expected > 2.5 * kMinSingleCovariance
                              ? static_cast<float>(K.data()[u * kGroup + c])
                              : 0.0F);
            }
            EXPECT_NEAR(mean.data()[c], sum, 1e-12) << kernels->name << " column " << c;
            EXPECT_EQ(mean.data()[c], meanToo.data()[c]);
        }
    }
}

TEST_P(CovarianceKernelsOf, droppedRowsCountInTheMeanOnly)
{
    const int U = GetParam();
    Covariances data(U);
    for (const CovarianceKernels* kernels : variants()) {
        AlignedArray<double> all(static_cast<std::size_t>(U) * kGroup), some(all.size());
        AlignedArray<double> mean(kGroup), meanToo(kGroup);
        data.in.kept = U;
        kernels->covariances(data.in, data.Z.data(), all.data(), mean.data());
        data.in.kept = U / 2;
        std::fill(some.data(), some.data() + some.size(), -7.0);
        kernels->covariances(data.in, data.Z.data(), some.data(), meanToo.data());
        for (int u = 0; u < U; ++u)
            for (int c = 0; c < kGroup; ++c)
                EXPECT_EQ(some.data()[u * kGroup + c],
                          u < U / 2 ? all.data()[u * kGroup + c] : -7.0);
        for (int c = 0; c < kGroup; ++c) EXPECT_EQ(mean.data()[c], meanToo.data()[c]);

        AlignedArray<float> single(all.size());
        std::fill(single.data(), single.data() + single.size(), -7.0F);
        kernels->covariancesSingle(data.in, data.Z.data(), single.data(), meanToo.data());
        for (int c = 0; c < kGroup; ++c) {
            EXPECT_EQ(mean.data()[c], meanToo.data()[c]);
            if (U > 1) {
                EXPECT_GE(single.data()[(U / 2 - 1) * kGroup + c], 0.0F);
            }
            EXPECT_EQ(single.data()[U / 2 * kGroup + c], -7.0F);
        }
    }
}

TEST(CovarianceKernels, haveTheExponentialToTheLastBits)
{
    constexpr int U = 4001;
    AlignedArray<double> none(1), weight(U), alpha(U), K(U * kGroup), mean(kGroup);
    for (int u = 0; u < U; ++u) weight.data()[u] = -5.0 * u / (U - 1);
    for (const CovarianceKernels* kernels : variants()) {
        kernels->covariances({none.data(), none.data(), weight.data(), alpha.data(), U, U, 0, 1.0},
                             none.data(), K.data(), mean.data());
        for (int u = 0; u < U; ++u) {
            const double expected = std::exp(weight.data()[u]);
            EXPECT_NEAR(K.data()[u * kGroup], expected, 4e-16 * expected)
                << kernels->name << " at " << weight.data()[u];
        }
        EXPECT_EQ(K.data()[0], 1.0);
    }
}

/// A triangle in panels and covariances with zeros from row U on.
template <class T>
struct Product {
    Product(int rows, int groupCount)
        : U(rows), groups(groupCount), triangle(random<T>(static_cast<std::size_t>(U * U), rng)),
          panels(static_cast<std::size_t>(panelStart<T>(paddedRows(U)))),
          K(random<T>(static_cast<std::size_t>(groups * paddedRows(U) * kGroup), rng))
    {
        for (int g = 0; g < groups; ++g)
            for (int k = U * kGroup; k < paddedRows(U) * kGroup; ++k)
                K.data()[g * paddedRows(U) * kGroup + k] = T{};
        for (int i = 0; i < U; ++i) {
            const int first = i / kPanelRows<T> * kPanelRows<T>;
            for (int j = 0; j <= i; ++j)
                panels.data()[panelStart<T>(first) + j * kPanelRows<T> + i - first] =
                    triangle.data()[i * U + j];
        }
    }
    double expected(int column) const
    {
        const T* k = K.data() + column / kGroup * paddedRows(U) * kGroup + column % kGroup;
        double sum = 0.0;
        for (int i = 0; i < U; ++i) {
            double product = 0.0;
            for (int j = 0; j <= i; ++j)
                product += static_cast<double>(triangle.data()[i * U + j])
                         * static_cast<double>(k[j * kGroup]);
            sum += product * product;
        }
        return sum;
    }
    std::vector<double> sums(const CovarianceKernels& kernels, KernelPoll poll = {}) const
    {
        AlignedArray<double> out(static_cast<std::size_t>(groups) * kGroup);
        if constexpr (sizeof(T) == sizeof(double))
            kernels.sumsOfSquares(panels.data(), K.data(), U, groups, out.data(), poll);
        else
            kernels.sumsOfSquaresSingle(panels.data(), K.data(), U, groups, out.data(), poll);
        return {out.data(), out.data() + out.size()};
    }

    int U;
    int groups;
    std::mt19937_64 rng{2};
    AlignedArray<T> triangle, panels, K;
};

template <class T>
void expectSums(int U, int groups, double tolerance)
{
    const Product<T> product(U, groups);
    for (const CovarianceKernels* kernels : variants()) {
        const std::vector<double> sums = product.sums(*kernels);
        for (int c = 0; c < groups * kGroup; ++c) {
            const double expected = product.expected(c);
            EXPECT_NEAR(sums[static_cast<std::size_t>(c)], expected, tolerance * expected)
                << kernels->name << ", " << U << " rows, column " << c;
        }
    }
}

TEST_P(CovarianceKernelsOf, sumSquaresInBothPrecisionsOnAllInstructionSets)
{
    for (const int groups : {1, 3}) {
        expectSums<double>(GetParam(), groups, 1e-13);
        expectSums<float>(GetParam(), groups, 3e-6);
    }
}

TEST(CovarianceKernels, pollWhileTheySumSquares)
{
    struct Stop {};
    const Poll stop = [] { throw Stop{}; };
    constexpr int kRows = 1200, kGroups = 24;
    constexpr long kAll = long{kRows} * kRows / 2 * kGroups * kGroup;
    const Product<float> product(kRows, kGroups);
    for (const CovarianceKernels* kernels : variants()) {
        int polls = 0;
        const Poll count = [&] { ++polls; };
        EXPECT_EQ(product.sums(*kernels, kernelPoll(count)), product.sums(*kernels));
        EXPECT_GE(polls, kAll / (kKernelMultiplications * 5 / 4)) << kernels->name;
        EXPECT_THROW((void)product.sums(*kernels, kernelPoll(stop)), Stop);
    }
}

INSTANTIATE_TEST_SUITE_P(Rows, CovarianceKernelsOf,
                         testing::Values(1, 4, 8, 17, 24, 25, 41, 48, 49, 97, 130));

TEST(CovarianceKernels, takeMoreGroupsThanTheyHoldAtOnce)
{
    expectSums<double>(30, 19, 1e-13);
    expectSums<float>(30, 19, 3e-6);
}

TEST(CovarianceKernels, giveAColumnTheSameBitsBesideAnyOther)
{
    const Product<float> many(97, 11);
    Product<float> one(97, 1);
    for (const CovarianceKernels* kernels : variants()) {
        const std::vector<double> all = many.sums(*kernels);
        for (int g = 0; g < many.groups; ++g) {
            const auto block = static_cast<std::size_t>(paddedRows(97)) * kGroup;
            for (std::size_t k = 0; k < block; ++k)
                one.K.data()[k] = many.K.data()[static_cast<std::size_t>(g) * block + k];
            const std::vector<double> sums = one.sums(*kernels);
            for (int c = 0; c < kGroup; ++c)
                EXPECT_EQ(sums[static_cast<std::size_t>(c)],
                          all[static_cast<std::size_t>(g * kGroup + c)])
                    << kernels->name;
        }
    }
}

TEST(CovarianceKernels, withFusedProductsGiveTheSameBits)
{
    const Product<double> product(130, 2);
    const Product<float> single(130, 2);
    const Covariances data(37);
    std::vector<std::vector<double>> results;
    for (const CovarianceKernels* kernels : variants()) {
        const std::string_view name = kernels->name;
        if (name != "AVX-512" && name != "AVX2") continue;
        std::vector<double> all = product.sums(*kernels);
        const std::vector<double> more = single.sums(*kernels);
        all.insert(all.end(), more.begin(), more.end());
        AlignedArray<double> K(37 * kGroup);
        AlignedArray<double> mean(kGroup);
        kernels->covariances(data.in, data.Z.data(), K.data(), mean.data());
        all.insert(all.end(), K.data(), K.data() + K.size());
        all.insert(all.end(), mean.data(), mean.data() + kGroup);
        results.push_back(all);
    }
    if (results.size() < 2) GTEST_SKIP() << "this processor runs one of AVX-512 and AVX2 at most";
    EXPECT_EQ(results[0], results[1]);
}

}  // namespace
}  // namespace terratact
