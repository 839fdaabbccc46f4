#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/kernels/covariance_block.h"

namespace terratact {

/// Rows Z of X that stand for all: the pivots of a pivoted Cholesky k(X, X) ≈ V Vᵀ.
struct InducingRows {
    std::vector<int> rows;  ///< m of X, in the order chosen
    Eigen::MatrixXd
        V;  ///< n × m: k(X, Z) L⁻ᵀ; its rows Z are, but for rounding, L of k(Z, Z) = L Lᵀ
    double left = 0.0;  ///< the largest variance of a row that is left, given the rows chosen
};

/// When to stop choosing, and how to choose.
struct RowsWanted {
    Eigen::Index most;           ///< rows
    double leastVariance = 0.0;  ///< of a row that is worth choosing
    /// A row is good enough whose variance given the rows chosen so far is at least this share of the largest; with 1 it
    /// is always the one with the largest, the first of equals.  Less takes about as many rows and half the time.
    double share = 1.0;
    /// Where half of `most` leave more than this, no more are chosen.
    double mostHalfway = std::numeric_limits<double>::infinity();
};

/// Greedily, see RowsWanted; no random numbers.
///   X: n rows.  Cost: n m² / 2 multiplications; memory: n · most doubles, n m of them used.
InducingRows chooseInducingRows(const ScaledRows& X, double signal2, const RowsWanted& wanted,
                                const Poll& poll = {});

/// The other ones of so many rows, in order.
std::vector<int> rowsNotIn(const std::vector<int>& chosen, Eigen::Index rows);

/// L: m × m, zeros above.
Eigen::MatrixXd factorOf(const InducingRows& inducing, const Poll& poll = {});

}  // namespace terratact
