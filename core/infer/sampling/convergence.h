#pragma once

#include <Eigen/Core>
#include <limits>

#include "core/base/poll.h"

namespace terratact {

/// R-hat of chains that do not move, and the largest value returned. The true value would be
/// infinite or undefined, but an estimate's numbers are finite.
inline constexpr double kRhatNever = 1e6;

/// Convergence diagnostics of draws. Ranks are computed once, when first needed.
///
/// R-hat and ESS are undefined if all draws are equal, and the R package posterior then returns NA.
/// Stuck chains cannot be distinguished from chains of a certain quantity, unless no draw can pass
/// a bound. Draws that all lie at that bound have converged; all other constant draws have not.
/// Such draws are the point mass of CeilingRule::Clamp. They also occur at a ceiling so far below
/// the mean that one deviation there is less than a rounding.
class RankedDraws {
public:
    /// draws: n × chains, one chain per column, any unit; must outlive this object.
    /// poll: called at least once for every chain, here and below. bound: no draw can lie above it.
    /// Throws std::invalid_argument for no draws and for a value that is not finite.
    explicit RankedDraws(const Eigen::Ref<const Eigen::MatrixXd>& draws, Poll poll = {},
                         double bound = std::numeric_limits<double>::infinity());

    /// Returns the rank-normalised split R-hat.
    ///
    /// Every chain is cut in halves (the middle draw of an odd n is dropped). The draws are
    /// replaced by normal scores z = Φ⁻¹((rank − 3/8) / (S + 1/4)); ties get their average rank.
    /// Then
    ///   R-hat = √(((n − 1)/n W + B/n) / W),  W, B: variance within and between the half chains.
    /// The result is the larger R-hat of the draws and of |draws − median|, as in `rhat()` of
    /// posterior.
    ///
    /// Two cases that `rhat()` leaves undefined give kRhatNever. They are fewer than four draws per
    /// chain, and half chains that are all constant. All draws at the bound give 1. If only the
    /// folded draws are all equal (two heights in turn), the draws alone decide. Source: Vehtari,
    /// Gelman, Simpson, Carpenter, Bürkner, Bayesian Analysis 16 (2021).
    double rhat();

    /// Returns the bulk effective sample size of the same normal scores, as `ess_bulk()` of
    /// posterior. It is S / τ, at most S log₁₀ S. τ comes from Geyer's initial monotone sequence
    /// over the mean autocovariance of the half chains.
    ///
    /// Two cases that `ess_bulk()` leaves undefined give the number of chains. They are fewer than
    /// six draws per chain, and half chains that are all constant. All draws at the bound give the
    /// number of draws.
    double ess();

private:
    bool heldByBound() const;
    const Eigen::MatrixXd& scores();

    Eigen::Ref<const Eigen::MatrixXd> draws_;
    Poll poll_;
    double bound_;
    Eigen::MatrixXd scores_;  ///< normal scores of the half chains; empty: not yet needed
};

}  // namespace terratact
