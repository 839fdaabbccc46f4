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

    /// Returns the probability that a correct sampler gives ranks at least this uneven. It is the smallest p-value of
    /// the quantities' chi-square tests against equal counts (L degrees of freedom), times their number (Bonferroni),
    /// at most 1.
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

/// Simulation-based calibration: where truth and data are drawn from the model that the sampler assumes, the
/// rank of any quantity of the truth among those of L independent draws of its posterior is uniform on
/// 0 … L.
///   simulate    draws the truth and the problem of the next set; chains, sweeps and seed are set here
///   sample      the sampler under test
///   quantities  what is ranked, of truth and draws; needs one that relates unknown and known bins: the ranks
///               of the heights alone are uniform too for a sampler that ignores what is known
/// L = `draws` chains of which one draw is kept each, after `burnIn` sweeps: independent by construction,
/// so nothing needs thinning.
/// Source: Talts, Betancourt, Simpson, Vehtari, Gelman, arXiv:1804.06788 (2018), Algorithm 1; quantities that
/// see the data: Modrák et al., "Simulation-based calibration checking for Bayesian computation", 2023.
RankHistograms calibrationRanks(int sets, int draws, int burnIn,
                                const std::function<SimulatedSet()>& simulate,
                                const std::function<GibbsDraws(const GibbsProblem&)>& sample,
                                const std::function<Eigen::VectorXd(const Heights&)>& quantities);

}  // namespace terratact
