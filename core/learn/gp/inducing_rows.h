#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/kernels/covariance_block.h"

namespace terratact {

/// Inducing rows Z of X: the pivots of a pivoted Cholesky factorisation k(X, X) ≈ V Vᵀ.
struct InducingRows {
    std::vector<int> rows;  ///< m rows of X, in the order chosen
    /// n × m: k(X, Z) L⁻ᵀ; its rows Z equal L of k(Z, Z) = L Lᵀ, except for rounding.
    Eigen::MatrixXd V;
    double left = 0.0;  ///< largest variance of a remaining row, given the chosen rows
};

/// Stopping and selection rule of chooseInducingRows().
struct RowsWanted {
    Eigen::Index most;           ///< largest number of rows
    double leastVariance = 0.0;  ///< least variance of a row that is worth choosing
    /// A row qualifies if its variance, given the chosen rows, is at least this share of the
    /// largest. With 1 it is always the first row with the largest variance. A smaller share needs
    /// about as many rows and half the time.
    double share = 1.0;
    /// If half of `most` rows leave a larger variance than this, no more are chosen.
    double mostHalfway = std::numeric_limits<double>::infinity();
};

/// Chooses inducing rows greedily (RowsWanted), without random numbers.
///   X: n rows.  Cost: n m² / 2 multiplications; memory: n · most doubles, of which n m are used.
InducingRows chooseInducingRows(const ScaledRows& X, double signal2, const RowsWanted& wanted,
                                const Poll& poll = {});

/// Returns the remaining rows of this many, in order.
std::vector<int> rowsNotIn(const std::vector<int>& chosen, Eigen::Index rows);

/// Returns L: m × m, zeros above the diagonal.
Eigen::MatrixXd factorOf(const InducingRows& inducing, const Poll& poll = {});

}  // namespace terratact
