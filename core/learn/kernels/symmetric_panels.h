#pragma once

#include <Eigen/Core>
#include <limits>

#include "core/base/poll.h"
#include "core/learn/kernels/aligned_array.h"

namespace terratact {

/// The lower triangle of a symmetric n × n matrix in panels of kPanelColumns columns, each panel with the rows
/// from its first column's on, row by row.  n is filled up to a multiple of 8 with rows of the identity.
/// Memory: about n²/2 + 48 n doubles, and 200 n more during invert().
class SymmetricPanels {
public:
    static constexpr int kPanelColumns = 96;

    /// All zero but for the rows of the identity.  poll: here and below, every few milliseconds; what it throws comes out.
    explicit SymmetricPanels(int n, const Poll& poll = {});
    SymmetricPanels(const SymmetricPanels&) = delete;
    SymmetricPanels& operator=(const SymmetricPanels&) = delete;

    int size() const { return n_; }
    int paddedSize() const { return padded_; }
    int panels() const { return (padded_ + kPanelColumns - 1) / kPanelColumns; }

    /// kPanelColumns entries of row u from column panel · kPanelColumns on; those right of the
    /// diagonal mean nothing.  u ≥ panel · kPanelColumns.
    double* row(int panel, int u);
    const double* row(int panel, int u) const;

    /// What inverting tells: log det A, yᵀ A⁻¹ y, and the least and largest entry of the Cholesky factor's
    /// diagonal, the square of whose quotient is never below A's reciprocal condition number.
    struct Factors {
        double logDeterminant = 0.0;
        double quadratic = 0.0;
        double leastPivot = std::numeric_limits<double>::infinity(), mostPivot = 0.0;
    };

    /// A becomes −A⁻¹ and y becomes A⁻¹ y; rows beyond n must be the identity's.
    /// One pass of the block sweep (Goodnight, "A tutorial on the SWEEP operator", Am. Stat. 33, 1979): for
    /// each block k of rows with A_kk = L Lᵀ and W = A_·k L⁻ᵀ
    ///   A_ij −= W_i W_jᵀ (i, j ≠ k),  A_·k = W L⁻¹,  A_kk = −L⁻ᵀ L⁻¹,
    /// n³ multiplications and additions in all, nearly all in one matrix product.
    /// Returns false, the contents lost, where A is not positive definite (or not finite); they are also where it polls.
    bool invert(Eigen::VectorXd& y, Factors& factors, const Poll& poll = {});

private:
    long offset(int panel, int u) const;

    int n_, padded_;
    AlignedArray<double> values_;
};

}  // namespace terratact
