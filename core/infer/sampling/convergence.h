#pragma once

#include <Eigen/Core>
#include <limits>

#include "core/base/poll.h"

namespace terratact {

/// R-hat of chains that stand still, and the largest value returned: it would be infinite or undefined, but an
/// estimate's numbers are finite.
inline constexpr double kRhatNever = 1e6;

/// What draws say about whether their chains have converged; ranks are computed once, when first needed.
///
/// Of draws that are all the same the two numbers are undefined, and posterior gives NA: chains that are stuck look the
/// same as chains of a quantity that is certain.  What tells them apart is a bound that no draw can pass: draws that
/// all lie at it are the point mass that the bound makes of whatever is far beyond it (CeilingRule::Clamp, or a
/// ceiling so far below that one deviation there is less than a rounding).  Those have converged; all others have not.
class RankedDraws {
public:
    /// draws: n × chains, one chain per column, any unit; must outlive it.
    /// poll: here and below, at least once for every chain.  bound: no draw can lie above it.
    /// Throws std::invalid_argument for no draws or a value that is not finite.
    explicit RankedDraws(const Eigen::Ref<const Eigen::MatrixXd>& draws, Poll poll = {},
                         double bound = std::numeric_limits<double>::infinity());

    /// Rank-normalised split R-hat.
    ///
    /// Every chain is cut in halves (the middle draw of an odd n is dropped), the draws are replaced by normal
    /// scores z = Φ⁻¹((rank − 3/8) / (S + 1/4)), ties by their average rank, and
    ///   R-hat = √(((n − 1)/n W + B/n) / W),  W, B: variance within and between the half chains.
    /// The larger of that for the draws and for |draws − median|, as `rhat()` of the R package posterior.
    ///
    /// What that function leaves undefined: fewer than four draws per chain, and half chains that are all constant, the
    /// same or not, give kRhatNever; all draws at the bound give 1.  Where only the folded draws are all equal (two heights in
    /// turn), the draws alone decide.
    /// Source: Vehtari, Gelman, Simpson, Carpenter, Bürkner, Bayesian Analysis 16 (2021).
    double rhat();

    /// Bulk effective sample size of the same normal scores: S / τ with τ from Geyer's initial monotone
    /// sequence over the mean autocovariance of the half chains; at most S log₁₀ S.  As `ess_bulk()` of posterior.
    ///
    /// What that function leaves undefined: half chains that are all constant, the same or not, and fewer than six
    /// draws per chain give the number of chains; all draws at the bound give the number of draws.
    double ess();

private:
    bool heldByBound() const;
    const Eigen::MatrixXd& scores();

    Eigen::Ref<const Eigen::MatrixXd> draws_;
    Poll poll_;
    double bound_;
    Eigen::MatrixXd scores_;  ///< of the half chains; empty: not yet needed
};

}  // namespace terratact
