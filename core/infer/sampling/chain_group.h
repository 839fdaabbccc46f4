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

/// Returns the bins without a known height, rear to front.
std::vector<int> unknownBins(const OptionalHeights& known);

/// Order in which a sweep visits the positions in I; the same for all chains of a scene.
class SweepOrder {
public:
    SweepOrder(ScanOrder scan, std::uint64_t seed);
    /// Returns the order of the next sweep. count: |I|.
    const std::vector<std::size_t>& next(std::size_t count);

private:
    void shuffle();

    ScanOrder scan_;
    std::mt19937_64 rng_;
    std::vector<std::size_t> order_;
};

/// A group of a scene's chains that advance together.
class ChainGroup {
public:
    /// first, count: range of the problem's chains. poll: called before each bin is drawn, and
    /// during long draws; may be empty.
    ChainGroup(const Conditionals& conditionals, const GibbsProblem& problem, int first, int count,
               Poll poll);

    const std::vector<int>& bins() const { return bins_; }
    /// Returns the states: |I| × chains.
    const Eigen::MatrixXd& states() const { return states_; }

    /// Draws every unknown bin of every group once, each group in its own order. Scenes that reach
    /// a bin at the same time ask its process together. Every group's draws are the same as when it
    /// sweeps alone.
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
    std::span<const std::size_t> left_;  // positions that remain in this sweep
};

}  // namespace terratact
