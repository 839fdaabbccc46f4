#include "core/learn/gp/inverse_factor.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <future>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "core/learn/gp/lazy_processes.h"
#include "core/learn/kernels/aligned_array.h"
#include "core/learn/kernels/covariance_kernels.h"

namespace terratact {
namespace {

/// Returns R = Lᵀ of a covariance with correlated neighbours; noise: added to the diagonal.
Eigen::MatrixXd someFactor(int U, double noise)
{
    Eigen::MatrixXd K(U, U);
    for (int i = 0; i < U; ++i)
        for (int j = 0; j < U; ++j)
            K(i, j) = std::exp(-0.5 * std::pow(0.2 * (i - j), 2)) + (i == j ? noise : 0.0);
    return Eigen::LLT<Eigen::MatrixXd>(K).matrixU();
}

template <class T>
T entry(const T* panels, int i, int j)
{
    const int first = i / kPanelRows<T> * kPanelRows<T>;
    return panels[panelStart<T>(first) + j * kPanelRows<T> + i - first];
}

class InverseFactorOf : public testing::TestWithParam<int> {};

TEST_P(InverseFactorOf, holdsTheInverseInBothPrecisionsInAnyOrder)
{
    const int U = GetParam();
    const Eigen::MatrixXd R = someFactor(U, 0.01);
    const Eigen::MatrixXd inverse = R.transpose().inverse();
    for (const bool singleFirst : {false, true}) {
        int again = 0;
        const InverseFactor factor(R, [&](const Poll&) {
            ++again;
            return R;
        });
        if (singleFirst) (void)factor.single().panels.data();
        const double* panels = factor.panels();
        const float* single = factor.single().panels.data();
        EXPECT_EQ(again, 1);
        for (int i = 0; i < U; ++i) {
            for (int j = 0; j <= i; ++j) {
                ASSERT_NEAR(entry(panels, i, j), inverse(i, j), 1e-9) << i << ", " << j;
                ASSERT_EQ(entry(single, i, j), static_cast<float>(entry(panels, i, j)));
            }
            for (int j = i + 1; j < i / kPanelRows<double> * kPanelRows<double>; ++j)
                ASSERT_EQ(entry(panels, i, j), 0.0);
        }
        EXPECT_EQ(factor.panels(), panels);
        EXPECT_EQ(again, 1);
    }
}

INSTANTIATE_TEST_SUITE_P(Rows, InverseFactorOf, testing::Values(1, 2, 24, 47, 48, 49, 150));

TEST(InverseFactor, measuresTheErrorOfSinglePrecision)
{
    const auto errorWith = [](double noise) {
        return InverseFactor(someFactor(200, noise),
                             [=](const Poll&) { return someFactor(200, noise); })
            .single()
            .error;
    };
    EXPECT_LT(errorWith(0.1), 1e-5);
    EXPECT_GT(errorWith(1e-10), 1e-4);
    EXPECT_GT(errorWith(1e-10), errorWith(1e-4));
}

TEST(InverseFactor, isPackedOnceForAllThreads)
{
    const Eigen::MatrixXd R = someFactor(60, 0.01);
    const InverseFactor factor(R, [&](const Poll&) { return R; });
    std::vector<const float*> seen(4);
    {
        std::vector<std::jthread> threads;
        for (const float*& panels : seen)
            threads.emplace_back([&factor, &panels] { panels = factor.single().panels.data(); });
    }
    for (const float* panels : seen) EXPECT_EQ(panels, factor.single().panels.data());
}

struct Stopped {};

/// Returns true if a caller is polled, and can leave, while another one is inside `held`. `held`
/// calls its argument inside.
bool canLeaveWhileAnotherIsInside(const std::function<void(const std::function<void()>&)>& held,
                                  const std::function<void(const Poll&)>& get)
{
    std::promise<void> inside, leave;
    const std::jthread holder([&] {
        held([&] {
            inside.set_value();
            leave.get_future().wait();
        });
    });
    inside.get_future().wait();
    auto waiting = std::async(std::launch::async, [&] {
        try {
            get([] { throw Stopped{}; });
            return false;
        } catch (const Stopped&) {
            return true;
        }
    });
    const bool left = waiting.wait_for(std::chrono::seconds(20)) == std::future_status::ready;
    leave.set_value();
    return left && waiting.get();
}

TEST(InverseFactor, pollsWhileAnotherThreadPacks)
{
    const Eigen::MatrixXd R = someFactor(60, 0.01);
    std::function<void()> pause = [] {};
    const InverseFactor factor(R, [&](const Poll&) {
        pause();
        return R;
    });
    (void)factor.panels();  // R is released
    EXPECT_TRUE(canLeaveWhileAnotherIsInside(
        [&](const std::function<void()>& wait) {
            pause = wait;
            (void)factor.single().panels.data();
        },
        [&](const Poll& poll) { (void)factor.single(poll); }));
    EXPECT_EQ(entry(factor.single().panels.data(), 59, 5),
              static_cast<float>(entry(factor.panels(), 59, 5)));
}

TEST(LazyProcesses, pollWhileAnotherThreadFactorises)
{
    const LazyProcesses lazy;
    const auto make = [] {
        return std::make_unique<GaussianProcess>(
            Eigen::MatrixXd::Identity(3, 2), Eigen::Vector3d::Ones(),
            Hyperparameters{Eigen::Vector2d::Ones(), 1.0, 0.1}, 0.0);
    };
    EXPECT_TRUE(canLeaveWhileAnotherIsInside(
        [&](const std::function<void()>& wait) {
            (void)lazy.get(0,
                           [&] {
                               wait();
                               return make();
                           },
                           {});
        },
        [&](const Poll& poll) { (void)lazy.get(0, make, poll); }));
    EXPECT_EQ(lazy.get(0, make, {}).rows(), 3);
}

TEST(InverseFactor, isPackedByTheNextCallerAfterACancellation)
{
    struct Stop {};
    const Eigen::MatrixXd R = someFactor(300, 0.01);
    const auto again = [&](const Poll& poll) {
        poll();
        return R;
    };
    const InverseFactor whole(R, again);
    int polls = 0;
    (void)whole.single([&] { ++polls; });
    EXPECT_GT(polls, 9);  // of the inversion, and one for each of seven panels
    const InverseFactor factor(R, again);
    for (int last = 1; last <= polls; last += 2) {
        int left = last;
        EXPECT_THROW((void)factor.single([&] {
            if (--left == 0) throw Stop{};
        }),
                     Stop);
    }
    EXPECT_EQ(entry(factor.single([] {}).panels.data(), 299, 5),
              entry(whole.single().panels.data(), 299, 5));
}

/// Reduction of K from someFactor(U, 0.01): its inverse without the last row. It is exact for
/// columns that do not depend on that row.
struct Reduction {
    Eigen::MatrixXd R;
    ReducedInverse inverse;

    Reduction(int U, double off) : R(someFactor(U, 0.01))
    {
        const int m = U - 1;
        const Eigen::MatrixXd turned = R.inverse().topLeftCorner(m, m);
        for (int u = 0; u < U; ++u) inverse.order.push_back(u);
        inverse.transposed = turned;
        inverse.probes = Eigen::MatrixXd::Random(m, InverseFactor::kProbes).cwiseAbs() * 0.01;
        inverse.squares = (turned.transpose() * inverse.probes).colwise().squaredNorm();
        inverse.squares[5] += off;
        inverse.weights = Eigen::VectorXd::Ones(InverseFactor::kProbes);
        inverse.weights[5] = 0.5;
        inverse.mostError = 1e-3;
    }
    InverseFactor factor(int& asked, int& again) const
    {
        return InverseFactor(
            R,
            [this, &again](const Poll&) {
                ++again;
                return R;
            },
            [this, &asked](const Eigen::MatrixXd& given, const Poll& poll) {
                EXPECT_EQ(given, R);
                ++asked;
                callPoll(poll);
                return inverse;
            });
    }
};

TEST(InverseFactor, usesAReductionThatIsAccurateByItsWeights)
{
    int asked = 0, again = 0;
    const Reduction good(60, 1.8e-3);  // half of that counts
    const InverseFactor factor = good.factor(asked, again);
    const InverseFactor::Single& single = factor.single();
    EXPECT_EQ(single.kept, 59);
    EXPECT_EQ(single.order, good.inverse.order);
    EXPECT_NEAR(single.error, 0.9e-3, 1e-5);
    EXPECT_EQ(entry(single.panels.data(), 58, 5),
              static_cast<float>(good.inverse.transposed(5, 58)));
    EXPECT_EQ(factor.rows(), 60);
    EXPECT_NEAR(entry(factor.panels(), 59, 5), good.R.inverse()(5, 59), 1e-9);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(again, 1) << "R was given up";
}

TEST(InverseFactor, usesAllRowsIfTheReductionIsInaccurate)
{
    for (const double off : {2.2e-3, std::nan("")}) {
        int asked = 0, again = 0;
        const Reduction bad(60, off);
        const InverseFactor factor = bad.factor(asked, again);
        EXPECT_EQ(factor.single().kept, 60) << off;
        EXPECT_EQ(entry(factor.single().panels.data(), 59, 5),
                  entry(InverseFactor(bad.R, {}).single().panels.data(), 59, 5));
        EXPECT_EQ(asked, 1);
        EXPECT_EQ(again, 0) << "R is still there";
    }
}

TEST(InverseFactor, isReducedByTheNextCallerAfterACancellation)
{
    struct Stop {};
    int asked = 0, again = 0;
    const Reduction good(60, 0.0);
    const InverseFactor factor = good.factor(asked, again);
    EXPECT_THROW((void)factor.single([] { throw Stop{}; }), Stop);
    EXPECT_EQ(factor.single().kept, 59);
    EXPECT_EQ(asked, 2);
    EXPECT_EQ(again, 1);
}

/// Returns the flags of the mapping that holds an address (proc(5), VmFlags of smaps). Empty: the
/// system does not report them.
std::string mappingFlags(const void* address)
{
    const auto wanted = reinterpret_cast<std::uintptr_t>(address);
    std::ifstream maps("/proc/self/smaps");
    bool here = false;
    for (std::string line; std::getline(maps, line);) {
        std::uintptr_t begin = 0, end = 0;
        if (std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR " ", &begin, &end) == 2)
            here = begin <= wanted && wanted < end;
        if (here && line.starts_with("VmFlags:")) return line;
    }
    return {};
}

/// Returns whether the system shows that a mapping asks for huge pages. Under qemu-user it does not,
/// because madvise(2) does nothing there.
bool showsHugePages()
{
    constexpr std::size_t kBytes = 2 * kHugePage;
    void* own = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (own == MAP_FAILED) return false;
    madvise(own, kBytes, MADV_HUGEPAGE);
    const bool shown = mappingFlags(own).find(" hg") != std::string::npos;
    munmap(own, kBytes);
    return shown;
}

TEST(AlignedArray, liesInWholeHugePagesWhereItIsLarge)
{
    const auto remainder = [](const AlignedArray<float>& array, std::size_t boundary) {
        return reinterpret_cast<std::uintptr_t>(array.data()) % boundary;
    };
    const AlignedArray<float> none, few(100), many((kHugePage + kHugePage / 2) / sizeof(float));
    EXPECT_EQ(none.size(), 0U);
    EXPECT_EQ(remainder(few, 64), 0U);
    EXPECT_EQ(remainder(many, kHugePage), 0U);
    EXPECT_TRUE(
        std::all_of(many.data(), many.data() + many.size(), [](float x) { return x == 0.0F; }));
    if (!showsHugePages()) GTEST_SKIP() << "this system does not tell about huge pages";
    const std::string flags = mappingFlags(many.data() + many.size() - 1);
    EXPECT_NE(flags.find(" hg"), std::string::npos) << flags;
}

}  // namespace
}  // namespace terratact
