#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "core/infer/sampling/gibbs.h"

namespace terratact {

/// The bins of which nothing is known, rear to front.
std::vector<int> unknownBins(const OptionalHeights& known);

/// The positions in I that a sweep visits one after the other; the same for all chains of a scene.
class SweepOrder {
public:
    SweepOrder(ScanOrder scan, std::uint64_t seed);
    /// Of the next sweep; count: |I|.
    const std::vector<std::size_t>& next(std::size_t count);

private:
    void shuffle();

    ScanOrder scan_;
    std::mt19937_64 rng_;
    std::vector<std::size_t> order_;
};

/// Some of a scene's chains, side by side.
class ChainGroup {
public:
    /// first, count: among the problem's chains.  poll: before each bin that is drawn, and
    /// in between where that is long; may be empty.
    ChainGroup(const Conditionals& conditionals, const GibbsProblem& problem, int first, int count,
               Poll poll);

    const std::vector<int>& bins() const { return bins_; }
    /// |I| × chains.
    const Eigen::MatrixXd& states() const { return states_; }

    /// Draws every unknown bin of every group once, each group in its own order.  Scenes that are at the same bin
    /// at the same time ask its process together; the groups' draws are those they would make alone.
    static void sweep(std::span<ChainGroup* const> groups, PredictionRoom& room);

private:
    void begin();
    std::optional<int> nextBin() const;
    std::optional<ScenePrediction> ask();
    void drawNext();
    void startRandomly(const Conditionals& conditionals);
    void drawState(std::size_t k, std::size_t c, double mean, double sd);

    const GibbsProblem& problem_;
    Poll poll_;
    std::vector<int> bins_;
    SweepOrder order_;
    std::vector<std::mt19937_64> rng_;
    Eigen::MatrixXd states_;
    std::unique_ptr<SceneConditionals> conditionals_;
    Eigen::VectorXd mean_, variance_;
    std::span<const std::size_t> left_;  // of the order of this sweep
};

}  // namespace terratact
