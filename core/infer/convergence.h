#pragma once

#include <Eigen/Core>

#include "core/poll.h"

namespace terratact {

/// R-hat of chains that stand still at different heights, and the largest value returned: it would be
/// infinite, but an estimate's numbers are finite.
inline constexpr double kRhatNever = 1e6;

/// What draws say about whether their chains have converged; ranks are computed once, when first needed.
class RankedDraws {
public:
    /// draws: n × chains, one chain per column, any unit; must outlive it.
    /// poll: during the ranking.
    /// Throws std::invalid_argument for no draws or a value that is not finite.
    explicit RankedDraws(const Eigen::Ref<const Eigen::MatrixXd>& draws, Poll poll = {});

    /// Rank-normalised split R-hat.
    ///
    /// Every chain is cut in halves (the middle draw of an odd n is dropped), the draws are replaced by normal
    /// scores z = Φ⁻¹((rank − 3/8) / (S + 1/4)), ties by their average rank, and
    ///   R-hat = √(((n − 1)/n W + B/n) / W),  W, B: variance within and between the half chains.
    /// The larger of that for the draws and for |draws − median|, as `rhat()` of the R package posterior.
    ///
    /// What that function leaves undefined: all draws (or all folded draws) equal gives 1; half chains each
    /// constant, but not equal, and fewer than four draws per chain give kRhatNever.
    /// Source: Vehtari, Gelman, Simpson, Carpenter, Bürkner, Bayesian Analysis 16 (2021).
    double rhat();

    /// Bulk effective sample size of the same normal scores: S / τ with τ from Geyer's initial monotone
    /// sequence over the mean autocovariance of the half chains; at most S log₁₀ S.  As `ess_bulk()` of posterior.
    ///
    /// What that function leaves undefined: all draws equal gives the number of draws; half chains each
    /// constant, but not equal, and fewer than six draws per chain give the number of chains.
    double ess();

private:
    const Eigen::MatrixXd& scores();

    Eigen::Ref<const Eigen::MatrixXd> draws_;
    Poll poll_;
    Eigen::MatrixXd scores_;  ///< of the half chains; empty: not yet needed
};

}  // namespace terratact
