#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "core/infer/sampling/gibbs.h"

namespace terratact {

/// Ranks of the truth among the draws: a histogram per quantity.
class RankHistograms {
public:
    /// draws: number L of draws in every set; a rank is one of the L + 1 values 0 … L.
    explicit RankHistograms(int draws) : draws_(draws) {}

    /// Adds a set. truth: one value per quantity; draws: quantities × L. The rank is the number of draws below the
    /// truth. Throws std::invalid_argument if a size differs from the first call or from L.
    void add(const Eigen::VectorXd& truth, const Eigen::MatrixXd& draws);

    /// Returns the probability that a correct sampler gives ranks at least this uneven. Each quantity has a chi-square
    /// test against equal counts (L degrees of freedom). The result is the smallest p-value times their number
    /// (Bonferroni), at most 1.
    double pValue() const;

private:
    int draws_;
    std::vector<std::vector<int>> counts_;  // L + 1 counts per quantity
};

/// One set: the truth and the sampler's input.
struct SimulatedSet {
    Heights truth{};
    GibbsProblem problem;
};

/// Simulation-based calibration. Truth and data are drawn from the model that the sampler assumes. A quantity of the
/// truth then has a uniform rank, 0 … L, among L independent posterior draws.
///   simulate    draws the truth and the problem of the next set; chains, sweeps and seed are set here
///   sample      the sampler under test
///   quantities  functions of truth and draws that are ranked. At least one must relate unknown and known bins: the
///               ranks of heights alone are uniform even if a sampler ignores the known bins
/// L = `draws` chains give one draw each after `burnIn` sweeps. They are independent by construction and need no
/// thinning.
/// Source: Talts, Betancourt, Simpson, Vehtari, Gelman, arXiv:1804.06788 (2018), Algorithm 1. Quantities that depend on
/// the data: Modrák et al., "Simulation-based calibration checking for Bayesian computation", 2023.
RankHistograms calibrationRanks(int sets, int draws, int burnIn,
                                const std::function<SimulatedSet()>& simulate,
                                const std::function<GibbsDraws(const GibbsProblem&)>& sample,
                                const std::function<Eigen::VectorXd(const Heights&)>& quantities);

}  // namespace terratact
