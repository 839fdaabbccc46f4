#include "core/infer/sampling/gibbs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "tests/support/distributions.h"
#include "tests/support/infinity.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

const BinModels& models()
{
    static const BinModels toy(toyModel(), FeatureSet::Pa);
    return toy;
}

/// A scene of the toy campaign with all bins known, no ceilings.
GibbsProblem problemWith(std::initializer_list<int> unknown)
{
    static const Scene scene = someScenes(2, 99).front();
    GibbsProblem problem;
    problem.s = features(FeatureSet::Pa, scene.s);
    problem.known = scene.truth;
    for (const int i : unknown) problem.known[static_cast<std::size_t>(i)].reset();
    problem.ceiling.fill(kInfinity);
    problem.chains = 4;
    problem.burnIn = 10;
    problem.keptPerChain = 2500;
    return problem;
}

Heights heightsOf(const GibbsProblem& problem)
{
    Heights h{};
    for (std::size_t i = 0; i < kBins; ++i) h[i] = problem.known[i].value_or(0.0);
    return h;
}

std::vector<double> all(const Eigen::MatrixXd& draws)
{
    return {draws.data(), draws.data() + draws.size()};
}

TEST(Gibbs, withOneUnknownBinDrawsFromItsConditional)
{
    const GibbsProblem problem = problemWith({4});
    const GibbsDraws draws = sampleHeights(models(), problem);
    ASSERT_EQ(draws.bins, std::vector<int>{4});
    const Normal p = models().bin(4).predict(models().input(4, heightsOf(problem), problem.s));
    EXPECT_LT(
        kolmogorov(all(draws.draws[0]), truncatedCdf(kInfinity, p.mean, std::sqrt(p.variance))),
        2.23);
}

TEST(Gibbs, truncatesAtTheCeiling)
{
    GibbsProblem problem = problemWith({4});
    const Normal p = models().bin(4).predict(models().input(4, heightsOf(problem), problem.s));
    const double sd = std::sqrt(p.variance);
    problem.ceiling[4] = p.mean - 0.5 * sd;
    const auto draws = all(sampleHeights(models(), problem).draws[0]);
    EXPECT_LE(*std::max_element(draws.begin(), draws.end()), problem.ceiling[4]);
    EXPECT_LT(kolmogorov(draws, truncatedCdf(problem.ceiling[4], p.mean, sd)), 2.23);
}

TEST(Gibbs, clampingPutsAPointMassOnTheCeiling)
{
    GibbsProblem problem = problemWith({4});
    problem.rule = CeilingRule::Clamp;
    const Normal p = models().bin(4).predict(models().input(4, heightsOf(problem), problem.s));
    problem.ceiling[4] = p.mean;  // half of a free Gaussian lies above the ceiling
    const auto draws = all(sampleHeights(models(), problem).draws[0]);
    const auto on = std::count(draws.begin(), draws.end(), problem.ceiling[4]);
    EXPECT_NEAR(static_cast<double>(on) / static_cast<double>(draws.size()), 0.5, 0.025);
    EXPECT_LE(*std::max_element(draws.begin(), draws.end()), problem.ceiling[4]);
}

TEST(Gibbs, twoUnknownBinsReachTheirFixedPoint)
{
    // Both conditionals are Gaussian. Their means are nearly linear in the other bin over the
    // draws' width. The conditional means of the draws must therefore average to the bin's own
    // mean.
    const GibbsProblem problem = problemWith({8, 9});
    const GibbsDraws draws = sampleHeights(models(), problem);
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        const int bin = draws.bins[k];
        double sum = 0.0;
        double variance = 0.0;
        int n = 0;
        for (Eigen::Index t = 0; t < draws.draws[0].size(); t += 10, ++n) {
            Heights h = heightsOf(problem);
            h[8] = draws.draws[0](t);
            h[9] = draws.draws[1](t);
            const Normal p = models().bin(bin).predict(models().input(bin, h, problem.s));
            sum += p.mean;
            variance = p.variance;
        }
        const double sd =
            std::sqrt((draws.draws[k].array() - draws.draws[k].mean()).square().mean());
        EXPECT_NEAR(draws.draws[k].mean(), sum / n, 0.1 * sd + 1e-4) << "bin " << bin;
        EXPECT_GE(sd, 0.95 * std::sqrt(variance)) << "bin " << bin;
    }
}

TEST(Gibbs, chainsRepeatWhateverTheirNumber)
{
    GibbsProblem problem = problemWith({2, 7, 9});
    problem.keptPerChain = 20;
    const GibbsDraws four = sampleHeights(models(), problem);
    const GibbsDraws again = sampleHeights(models(), problem);
    problem.chains = 9;
    const GibbsDraws nine = sampleHeights(models(), problem);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(four.draws[k], again.draws[k]);
        EXPECT_EQ(four.draws[k], nine.draws[k].leftCols(4));
    }
    problem.seed = 2;
    EXPECT_NE(sampleHeights(models(), problem).draws[0], nine.draws[0]);
}

TEST(Gibbs, drawsTheSameInAnyThreadsAndGroups)
{
    GibbsProblem problem = problemWith({2, 7, 9});
    problem.keptPerChain = 20;
    problem.chains = 45;
    for (const ScanOrder scan : {ScanOrder::Forward, ScanOrder::Random}) {
        problem.scan = scan;
        const GibbsDraws together = sampleHeights(models(), problem);
        const std::map<int, int> partsOnThreads{{0, 6}, {1, 1}, {2, 2}, {3, 3}, {4, 3}, {99, 6}};
        for (const auto& [threads, wanted] : partsOnThreads) {
            Watch watch;
            int parts = 1;
            watch.threads = threads;
            watch.sideBySide = [&](int count, const std::function<void(int)>& work) {
                parts = count;
                std::vector<std::jthread> running;
                for (int i = 0; i < count; ++i) running.emplace_back(work, i);
            };
            EXPECT_EQ(sampleHeights(models(), problem, watch).draws, together.draws) << threads;
            EXPECT_EQ(parts, wanted) << threads;
        }
        GibbsProblem some = problem;
        some.firstChain = 5;
        some.chains = 13;
        const GibbsDraws few = sampleHeights(models(), some);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(few.draws[k], together.draws[k].middleCols(5, 13));
    }
}

TEST(Gibbs, inSeveralThreadsIsCancelledAndReportsOneByOne)
{
    GibbsProblem problem = problemWith({1, 2});
    problem.chains = 32;
    problem.keptPerChain = 10;
    Watch watch;
    std::vector<double> shares;
    watch.progress = [&](double share) { shares.push_back(share); };  // no lock needed
    std::atomic<bool> cancelled{false};
    watch.cancelled = [&] { return cancelled.load(); };
    const auto inThreads = [&](int count, const std::function<void(int)>& work) {
        std::atomic<int> stopped{0};
        {
            std::vector<std::jthread> threads;
            for (int i = 0; i < count; ++i)
                threads.emplace_back([&, i] {
                    try {
                        work(i);
                    } catch (const Cancelled&) {
                        ++stopped;
                    }
                });
        }
        if (stopped > 0) {
            EXPECT_EQ(stopped, count);
            throw Cancelled{};
        }
    };
    watch.sideBySide = inThreads;
    (void)sampleHeights(models(), problem, watch);
    EXPECT_EQ(shares.size(), 4 * 20 + 1);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0);
    cancelled = true;
    EXPECT_THROW((void)sampleHeights(models(), problem, watch), Cancelled);
}

/// Records which scene was requested for which bin.
class Noting final : public Conditionals, public SceneConditionals {
public:
    using Notes = std::vector<std::pair<char, int>>;
    Noting(char name, Notes& notes) : name_(name), notes_(notes) {}

    StartDraw start(int) const override { return {}; }
    std::unique_ptr<SceneConditionals> at(const Heights&,
                                          const std::vector<int>& unknown) const override
    {
        auto scene = std::make_unique<Noting>(*this);
        scene->unknown_ = unknown;
        return scene;
    }
    void predict(std::size_t k, const Eigen::MatrixXd& states, Eigen::VectorXd& mean,
                 Eigen::VectorXd& variance) override
    {
        notes_.emplace_back(name_, unknown_[k]);
        mean.setZero(states.cols());
        variance.setOnes(states.cols());
    }

private:
    char name_;
    Notes& notes_;
    std::vector<int> unknown_;
};

TEST(Gibbs, scenesWithDifferentBinsMeetAtTheSameBin)
{
    Noting::Notes notes;
    const Noting a('a', notes), b('b', notes), c('c', notes);
    const auto sweepOf = [&](ScanOrder scan) {
        GibbsProblem problems[] = {problemWith({5, 8}), problemWith({2, 5, 9}), problemWith({9})};
        for (GibbsProblem& problem : problems) problem.scan = scan;
        GibbsRun first(a, problems[0]), second(b, problems[1]), third(c, problems[2]);
        notes.clear();
        PredictionRoom room;
        GibbsRun::sweepTogether(std::array{&first, &second, &third}, room);
        return notes;
    };
    EXPECT_EQ(sweepOf(ScanOrder::Forward),
              (Noting::Notes{{'b', 2}, {'a', 5}, {'b', 5}, {'a', 8}, {'b', 9}, {'c', 9}}));
    EXPECT_EQ(sweepOf(ScanOrder::Reverse),
              (Noting::Notes{{'b', 9}, {'c', 9}, {'a', 8}, {'a', 5}, {'b', 5}, {'b', 2}}));
}

TEST(Gibbs, withNothingUnknownDrawsNothing)
{
    EXPECT_TRUE(sampleHeights(models(), problemWith({})).bins.empty());
}

TEST(Gibbs, canBeWatchedAndCancelled)
{
    GibbsProblem problem = problemWith({1, 2});
    double last = -1.0;
    int calls = 0;
    Watch watch;
    watch.progress = [&](double share) {
        EXPECT_GT(share, last);
        last = share;
    };
    watch.cancelled = [&] { return ++calls > 5; };
    EXPECT_THROW((void)sampleHeights(models(), problem, watch), Cancelled);
    EXPECT_EQ(calls, 6);
    problem.chains = 0;
    EXPECT_THROW((void)sampleHeights(models(), problem), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
