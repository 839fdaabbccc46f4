#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/infer/sampling/convergence.h"
#include "core/infer/sampling/draw_summary.h"
#include "core/infer/sampling/gibbs.h"
#include "tests/support/infinity.h"

namespace terratact {
namespace {

/// Toy conditionals with sd `sd`. The mean is `pull` times the last of the other unknown bins'
/// states. The bin numbered `stuck` has its own state as mean.
class Pulled final : public Conditionals, public SceneConditionals {
public:
    Pulled(double pull, double sd, std::optional<std::size_t> stuck = {})
        : pull_(pull), sd_(sd), stuck_(stuck)
    {
    }

    StartDraw start(int) const override { return {0.0, 1.0}; }
    double height(int, double state) const override { return 0.1 * state - 0.3; }
    std::unique_ptr<SceneConditionals> at(const Heights&, const std::vector<int>&) const override
    {
        return std::make_unique<Pulled>(*this);
    }
    void predict(std::size_t k, const Eigen::MatrixXd& states, Eigen::VectorXd& mean,
                 Eigen::VectorXd& variance) override
    {
        if (k == stuck_) {
            mean = states.row(static_cast<Eigen::Index>(k)).transpose();
            variance = Eigen::VectorXd::Constant(states.cols(), 1e-6);
            return;
        }
        const Eigen::Index other = k == 0 ? states.rows() - 1 : 0;
        mean = pull_ * states.row(other).transpose();
        variance = Eigen::VectorXd::Constant(states.cols(), sd_ * sd_);
    }

private:
    double pull_, sd_;
    std::optional<std::size_t> stuck_;
};

const Pulled& independent()
{
    static const Pulled conditionals(0.0, 1.0);
    return conditionals;
}

/// Each state follows the other one: the chains stay where they started.
const Pulled& stuck()
{
    static const Pulled conditionals(1.0, 1e-3);
    return conditionals;
}

GibbsProblem twoUnknown()
{
    GibbsProblem problem;
    for (auto& height : problem.known) height = 0.0;
    problem.known[2].reset();
    problem.known[7].reset();
    problem.ceiling.fill(kInfinity);
    problem.rule = CeilingRule::None;
    problem.burnIn = 5;
    problem.keptPerChain = 2000;
    problem.stopEarly = true;
    return problem;
}

Watch inThreads()
{
    Watch watch;
    watch.sideBySide = [](int count, const std::function<void(int)>& work) {
        std::vector<std::jthread> threads;
        for (int i = 0; i < count; ++i) threads.emplace_back(work, i);
    };
    return watch;
}

bool withinLimits(const Eigen::MatrixXd& draws)
{
    return RankedDraws(draws).rhat() <= kRhatLimit && RankedDraws(draws).ess() >= kEssLimit;
}

void expectFirstRows(const GibbsDraws& few, const GibbsDraws& all)
{
    ASSERT_EQ(few.draws.size(), all.draws.size());
    for (std::size_t k = 0; k < few.draws.size(); ++k)
        EXPECT_EQ(few.draws[k], all.draws[k].topRows(few.draws[k].rows()));
}

TEST(EarlyStop, endsAtTheFirstCheckWhereEveryBinHasConverged)
{
    GibbsProblem problem = twoUnknown();
    problem.chains = 8;  // the first checks see fewer than 400 draws
    const GibbsDraws draws = sampleStates(independent(), problem);
    EXPECT_EQ(draws.ending, Ending::Converged);
    Eigen::Index before = 0;
    Eigen::Index check = kFirstCheck;
    while (check < draws.draws[0].rows()) {
        before = check;
        check += (check + 1) / 2;
    }
    EXPECT_EQ(check, draws.draws[0].rows());
    EXPECT_LT(check, 300);
    EXPECT_TRUE(withinLimits(draws.draws[0]) && withinLimits(draws.draws[1]));
    ASSERT_GE(before, kFirstCheck);  // otherwise the next line tests nothing
    EXPECT_FALSE(withinLimits(draws.draws[0].topRows(before))
                 && withinLimits(draws.draws[1].topRows(before)));
}

TEST(EarlyStop, givesTheFirstDrawsOfTheWholeBudget)
{
    GibbsProblem problem = twoUnknown();
    const GibbsDraws few = sampleStates(independent(), problem);
    problem.stopEarly = false;
    const GibbsDraws all = sampleStates(independent(), problem);
    EXPECT_EQ(all.ending, Ending::Sweeps);
    EXPECT_EQ(all.draws[0].rows(), 2000);
    expectFirstRows(few, all);
}

TEST(EarlyStop, givesTheSameDrawsInSeveralThreads)
{
    GibbsProblem problem = twoUnknown();
    problem.chains = 21;
    const GibbsDraws alone = sampleStates(independent(), problem);
    const GibbsDraws together = sampleStates(independent(), problem, inThreads());
    EXPECT_EQ(alone.draws, together.draws);
    EXPECT_EQ(together.ending, Ending::Converged);
}

TEST(EarlyStop, drawsTheWholeBudgetWhereChainsNeverMix)
{
    GibbsProblem problem = twoUnknown();
    problem.keptPerChain = 301;
    const GibbsDraws draws = sampleStates(stuck(), problem);
    EXPECT_EQ(draws.ending, Ending::Sweeps);
    EXPECT_EQ(draws.draws[0].rows(), 301);
    EXPECT_GT(RankedDraws(draws.draws[0]).rhat(), kRhatLimit);
}

TEST(EarlyStop, waitsForTheOneBinWhoseChainsNeverMix)
{
    for (const std::size_t k : {0U, 1U}) {
        GibbsProblem problem = twoUnknown();
        problem.keptPerChain = 301;
        const GibbsDraws draws = sampleStates(Pulled(0.0, 1.0, k), problem);
        EXPECT_EQ(draws.ending, Ending::Sweeps) << k;
        EXPECT_TRUE(withinLimits(draws.draws[1 - k])) << k;
        EXPECT_FALSE(withinLimits(draws.draws[k])) << k;
    }
}

TEST(EarlyStop, alsoJudgesTheLastSweepOfTheBudget)
{
    GibbsProblem problem = twoUnknown();
    problem.keptPerChain = static_cast<int>(sampleStates(independent(), problem).draws[0].rows());
    EXPECT_EQ(sampleStates(independent(), problem).ending, Ending::Converged);
    problem.keptPerChain = 10;  // ends before the first regular check; 160 draws are too few
    const GibbsDraws draws = sampleStates(independent(), problem);
    EXPECT_EQ(draws.ending, Ending::Sweeps);
    EXPECT_EQ(draws.draws[0].rows(), 10);
}

TEST(TimeOut, keepsTheFirstDrawsOfALongerRun)
{
    GibbsProblem problem = twoUnknown();
    const GibbsDraws all = sampleStates(stuck(), problem);
    for (const bool threads : {false, true}) {
        Watch watch = threads ? inThreads() : Watch{};
        int asked = 0;
        watch.outOfTime = [&] { return ++asked > 20; };
        const GibbsDraws draws = sampleStates(stuck(), problem, watch);
        EXPECT_EQ(draws.ending, Ending::Time);
        EXPECT_GE(draws.draws[0].rows(), 20);
        EXPECT_LE(draws.draws[0].rows(), 100);
        expectFirstRows(draws, all);
    }
}

TEST(TimeOut, afterTheBurnInLeavesFourKeptSweeps)
{
    GibbsProblem problem = twoUnknown();
    const GibbsDraws all = sampleStates(stuck(), problem);
    Watch watch;
    int asked = 0;
    watch.outOfTime = [&] { return ++asked >= problem.burnIn; };
    const GibbsDraws draws = sampleStates(stuck(), problem, watch);
    EXPECT_EQ(draws.ending, Ending::Time);
    EXPECT_EQ(draws.draws[0].rows(), kMinKept);
    expectFirstRows(draws, all);
    EXPECT_EQ(draws.burnInLeftOut, 0);
    problem.keptPerChain = 2;
    asked = 0;
    EXPECT_EQ(sampleStates(stuck(), problem, watch).ending, Ending::Sweeps);
}

TEST(TimeOut, duringTheBurnInSkipsItsRest)
{
    GibbsProblem problem = twoUnknown();
    problem.burnIn = 1'000'000;
    for (const bool threads : {false, true})
        for (const int kept : {2, 2000}) {
            problem.keptPerChain = kept;
            Watch watch = threads ? inThreads() : Watch{};
            int asked = 0;
            watch.outOfTime = [&] { return ++asked >= 3; };
            const GibbsDraws draws = sampleStates(independent(), problem, watch);
            EXPECT_EQ(draws.ending, Ending::Time);
            EXPECT_EQ(draws.draws[0].rows(), std::min(kept, kMinKept));
            EXPECT_GE(draws.burnInLeftOut, problem.burnIn - 12);
            EXPECT_LE(draws.burnInLeftOut, problem.burnIn - 3);
            EXPECT_EQ(asked, 3);
        }
}

TEST(TimeOut, duringTheBurnInIsNeverCalledConverged)
{
    GibbsDraws draws;
    draws.bins = {0};
    draws.draws = {Eigen::MatrixXd::Zero(kMinKept, 1000)};
    draws.ending = Ending::Time;
    for (const int leftOut : {0, 7}) {
        draws.burnInLeftOut = leftOut;
        TerrainEstimate estimate;
        estimate.rhat[0] = 1.0;
        estimate.ess[0] = 4000.0;
        conclude(estimate, draws, {});
        EXPECT_EQ(estimate.converged, leftOut == 0);
        EXPECT_EQ(std::count_if(estimate.warnings.begin(), estimate.warnings.end(),
                                [](const Message& w) {
                                    return w.english().find("7 sweeps before the burn-in's end")
                                        != std::string::npos;
                                }),
                  leftOut == 0 ? 0 : 1);
    }
}

TEST(TimeOut, doesNotHideAConvergence)
{
    int asked = 0;
    Watch watch;
    watch.outOfTime = [&] {
        ++asked;
        return false;
    };
    const GibbsDraws draws = sampleStates(independent(), twoUnknown(), watch);
    EXPECT_EQ(draws.ending, Ending::Converged);
    // Called between all sweeps of the burn-in, and of all sweeps that may be the last.
    EXPECT_EQ(asked, draws.draws[0].rows() - kMinKept + twoUnknown().burnIn - 1);
}

TEST(Ending, ofAProblemWithoutUnknownsIsNotSampled)
{
    GibbsProblem problem = twoUnknown();
    problem.known.fill(0.0);
    const GibbsDraws draws = sampleStates(independent(), problem);
    EXPECT_EQ(draws.ending, Ending::NotSampled);
    EXPECT_TRUE(draws.draws.empty());
}

TEST(Draws, areHeightsOfTheStates)
{
    GibbsProblem problem = twoUnknown();
    problem.stopEarly = false;
    const GibbsDraws draws = sampleStates(independent(), problem);
    EXPECT_NEAR(draws.draws[0].mean(), -0.3, 0.01);
    EXPECT_NEAR(std::sqrt((draws.draws[0].array() + 0.3).square().mean()), 0.1, 0.01);
}

TEST(Progress, ofChainsThatEndEarlyReachesOne)
{
    std::vector<double> shares;
    Watch watch;
    watch.progress = [&](double share) { shares.push_back(share); };
    (void)sampleStates(independent(), twoUnknown(), watch);
    EXPECT_LT(shares[shares.size() - 2], 0.5);
    EXPECT_EQ(shares.back(), 1.0);
}

}  // namespace
}  // namespace terratact
