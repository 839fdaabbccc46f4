// An estimate polls for cancellation after bounded work.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <random>

#include "core/atem/probe/arm_choice.h"
#include "core/infer/estimator.h"
#include "core/infer/sampling/convergence.h"
#include "core/infer/sampling/draw_summary.h"
#include "core/infer/sampling/gibbs.h"
#include "core/learn/gp/cholesky.h"
#include "core/learn/gp/scene_conditional.h"
#include "tests/core/infer/extreme_scenes.h"
#include "tests/support/counted_blas.h"

namespace terratact {
namespace {

/// Returns the largest BLAS work of a computation between two polls.
BlasWork longestGap(const std::function<void(const Poll&)>& compute)
{
    BlasWork last = blasWork();
    BlasWork most;
    const auto seen = [&] {
        const BlasWork now = blasWork();
        most.multiplications =
            std::max(most.multiplications, now.multiplications - last.multiplications);
        most.read = std::max(most.read, now.read - last.read);
        last = now;
    };
    compute(seen);
    seen();
    return most;
}

TEST(Cancelling, largeModelPollsAfterBoundedWork)
{
    constexpr int kRows = 2500;
    std::mt19937_64 rng(3);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd X(kRows, 3);
    for (double& x : X.reshaped()) x = normal(rng);
    const Eigen::VectorXd y = X.col(0).array().sin();
    const Hyperparameters hyper{Eigen::Vector3d::Ones(), 1.0, 0.1};
    const BlasWork gap = longestGap([&](const Poll& poll) {
        const GaussianProcess gp(X, y, hyper, 0.0, poll);
        (void)SceneConditional(gp, Eigen::Vector3d::Zero(), {0}, Precision::Single, poll);
        (void)SceneConditional(gp, Eigen::Vector3d::Zero(), {0}, Precision::Double, poll);
        (void)GaussianProcess::sparse(X, y, 400, hyper, 0.0, poll)->usable(Precision::Single, poll);
    });
    EXPECT_LE(gap.multiplications, 1.3 * kMaxMultiplications);
    EXPECT_GT(gap.multiplications, 0.1 * kMaxMultiplications);  // they are counted
    const BlasWork solving = longestGap([&](const Poll& poll) {
        const Eigen::MatrixXd R = Eigen::MatrixXd::Identity(3500, 3500);
        Eigen::VectorXd x = R.col(0);
        Eigen::MatrixXd several = R.leftCols(3);
        solveWithFactor(R, x, poll);
        multiplyTransposed(R, several, poll);
        solveTransposed(R, several, poll);
        (void)reciprocalCondition(R, 1.0, poll);
    });
    EXPECT_LE(solving.read, 1.1 * kMaxRead);
}

/// Returns the number of polls of a computation.
int questions(const std::function<void(const Poll&)>& compute)
{
    int asked = 0;
    compute([&] { ++asked; });
    return asked;
}

TEST(Cancelling, pollsGrowWithTheNumberOfDraws)
{
    constexpr Eigen::Index kDraws = 300000;
    const auto least = [](int unitsPerDraw) {
        return static_cast<int>(unitsPerDraw * kDraws / PolledWork::kBetweenPolls);
    };
    std::mt19937_64 rng(3);
    std::normal_distribution<double> normal;
    GibbsDraws draws;
    draws.bins = {9};
    draws.draws = {Eigen::MatrixXd(kDraws / 100, 100)};
    for (double& x : draws.draws[0].reshaped()) x = normal(rng);

    EXPECT_GE(questions([&](const Poll& poll) { (void)RankedDraws(draws.draws[0], poll).rhat(); }),
              least(2 * 14));  // sorts twice
    EXPECT_GE(questions([&](const Poll& poll) { (void)RankedDraws(draws.draws[0], poll).ess(); }),
              least(14));
    TerrainEstimate estimate;
    EXPECT_GE(questions([&](const Poll& poll) {
                  summariseDraws(estimate, 9, draws.draws[0], Origin::Sampled, Centre::Mean, poll);
              }),
              least(3 * 14));
    EXPECT_GE(questions([&](const Poll& poll) { conclude(estimate, draws, {}, poll); }), least(11));
    EXPECT_GE(questions([&](const Poll& poll) { (void)finite(estimate, poll); }), least(11));
    EXPECT_GE(questions([&](const Poll& poll) { (void)adviseProbe(estimate, robot(), 0.1, poll); }),
              least(48 * 2));  // once for every reading
    for (const Method method : {Method::Local, Method::Joint}) {
        Asked many;
        many.settings.method = method;
        many.settings.draws = kDraws;
        many.settings.stopEarly = false;
        EXPECT_GE(questions([&](const Poll& poll) {
                      Watch watch;
                      watch.cancelled = [&] {
                          poll();
                          return false;
                      };
                      (void)estimateOf(many, watch);
                  }),
                  least(22 + 22 + 11));
    }
}

}  // namespace
}  // namespace terratact
