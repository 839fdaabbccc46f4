#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/poll.h"

namespace terratact {

/// Rows Z of X that stand for all: the pivots of a pivoted Cholesky k(X, X) ≈ V Vᵀ.
struct InducingRows {
    std::vector<int> rows;  ///< m of X, in the order chosen
    Eigen::MatrixXd
        V;  ///< n × m: k(X, Z) L⁻ᵀ; its rows Z are, but for rounding, L of k(Z, Z) = L Lᵀ
    double left = 0.0;  ///< the largest variance of a row that is left, given the rows chosen
};

/// At most `most` rows, greedily: one whose variance given the rows chosen so far is at least `share` of the largest,
/// with a share of 1 the one with the largest, the first of equals; fewer where none has more than leastVariance.  A
/// share of less takes about as many rows and half the time.  No random numbers.
///   scaled: n × d inputs in length scales.  Cost: n m² / 2 multiplications; memory: n m doubles.
InducingRows chooseInducingRows(const Eigen::MatrixXd& scaled, double signal2, Eigen::Index most,
                                double leastVariance, double share, const Poll& poll = {});

/// L: m × m, zeros above.
Eigen::MatrixXd factorOf(const InducingRows& inducing, const Poll& poll = {});

}  // namespace terratact
