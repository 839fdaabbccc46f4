#pragma once

#include <Eigen/Core>
#include <limits>

#include "core/base/poll.h"
#include "core/learn/kernels/aligned_array.h"

namespace terratact {

/// Lower triangle of a symmetric n × n matrix in panels of kPanelColumns columns. Each panel holds
/// the rows from its first column's index on, row by row. n is padded to a multiple of 8 with rows
/// of the identity. Memory: about n²/2 + 48 n doubles, and 200 n more during invert().
class SymmetricPanels {
public:
    static constexpr int kPanelColumns = 96;

    /// Makes a zero matrix, except for the identity's rows. poll: here and below, called every few
    /// milliseconds; what it throws is rethrown.
    explicit SymmetricPanels(int n, const Poll& poll = {});
    SymmetricPanels(const SymmetricPanels&) = delete;
    SymmetricPanels& operator=(const SymmetricPanels&) = delete;

    int size() const { return n_; }
    int paddedSize() const { return padded_; }
    int panels() const { return (padded_ + kPanelColumns - 1) / kPanelColumns; }

    /// Returns kPanelColumns entries of row u from column panel · kPanelColumns on. Entries right
    /// of the diagonal are undefined. u ≥ panel · kPanelColumns.
    double* row(int panel, int u);
    const double* row(int panel, int u) const;

    /// Results of the inversion: log det A, yᵀ A⁻¹ y, least and largest diagonal entry of the
    /// Cholesky factor. The square of their quotient is never below A's reciprocal condition
    /// number.
    struct Factors {
        double logDeterminant = 0.0;
        double quadratic = 0.0;
        double leastPivot = std::numeric_limits<double>::infinity(), mostPivot = 0.0;
    };

    /// Replaces A by −A⁻¹ and y by A⁻¹ y; rows beyond n must be the identity's. It is one pass of
    /// the block sweep (Goodnight, "A tutorial on the SWEEP operator", Am. Stat. 33, 1979). For
    /// each block k of rows with A_kk = L Lᵀ and W = A_·k L⁻ᵀ
    ///   A_ij −= W_i W_jᵀ (i, j ≠ k),  A_·k = W L⁻¹,  A_kk = −L⁻ᵀ L⁻¹.
    /// Cost: n³ multiplications and additions, nearly all in one matrix product. Returns false if A
    /// is not positive definite or not finite. The contents are undefined then, and after an
    /// exception of the poll.
    bool invert(Eigen::VectorXd& y, Factors& factors, const Poll& poll = {});

private:
    long offset(int panel, int u) const;

    int n_, padded_;
    AlignedArray<double> values_;
};

}  // namespace terratact
