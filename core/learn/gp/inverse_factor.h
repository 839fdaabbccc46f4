#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/polled_mutex.h"
#include "core/learn/gp/cholesky.h"
#include "core/learn/kernels/aligned_array.h"
#include "core/learn/kernels/covariance_kernels.h"
#include "core/learn/kernels/precision.h"

namespace terratact {

/// A triangle that is already inverted, and covariances at which single precision is judged.
struct GivenInverse {
    Eigen::MatrixXd transposed;  ///< Fᵀ: U × U, upper triangle
    Eigen::MatrixXd probes;      ///< U × InverseFactor::kProbes, full columns
};

/// Replacement of L⁻¹ in single precision: |F k_m|² with some rows k_m of k, and the data to judge
/// it.
struct ReducedInverse {
    /// k's rows: first the m rows that F needs, in its order, then the others
    std::vector<int> order;
    Eigen::MatrixXd transposed;  ///< Fᵀ: m × m, upper triangle
    Eigen::MatrixXd probes;      ///< m × InverseFactor::kProbes: k_m
    Eigen::VectorXd squares;     ///< |L⁻¹k|² at the probes
    Eigen::VectorXd weights;     ///< weights of the differences at the probes
    double mostError = 0.0;      ///< largest weighted difference with which F is used
};

/// L⁻¹ of K = L Lᵀ, U × U. It is packed in panels for CovarianceKernels when it is first needed, in
/// the precision that is needed: U² / 2 numbers each, or m² / 2 for a ReducedInverse. It may be
/// shared between threads; a thread that waits for the packing polls too. An exception of a poll
/// leaves the packing to the next caller.
///
/// Single precision changes |L⁻¹k|² by about ε Σ_i |v_i| Σ_j |L⁻¹_ij k_j|, ε = 6e-8. The products
/// grow with the condition number of K. The error is therefore measured at columns of K itself,
/// where |L⁻¹ K e_i|² = K_ii is known: Single::error. A GivenInverse is compared with its double
/// version at its probes. A ReducedInverse is used for single precision if there is one, and judged
/// at its own probes.
class InverseFactor {
public:
    /// Number of columns at which single precision is judged.
    static constexpr int kProbes = 2 * kGroup;
    /// Returns the p-th of kProbes indices below `count`, from the first to the last.
    static Eigen::Index probe(Eigen::Index p, Eigen::Index count)
    {
        return p * (count - 1) / (kProbes - 1);
    }

    /// The factor in single precision.
    struct Single {
        std::vector<int> order;      ///< k's rows; the panels multiply the first ones
        int kept = 0;                ///< number of these rows: all, unless reduced
        AlignedArray<float> panels;  ///< kept × kept
        /// Largest error of |L⁻¹k|² over kProbes columns: K e_i for rows i from the first to the
        /// last, or those of GivenInverse. It is at least 2⁻²³ of the largest value. For |F k_m|²
        /// it is the largest weighted error at the probes of ReducedInverse.
        double error = 0.0;
    };
    using Again = std::function<Eigen::MatrixXd(const Poll&)>;
    using Reduce =
        std::function<std::optional<ReducedInverse>(const Eigen::MatrixXd& R, const Poll&)>;

    /// R = Lᵀ, upper triangle; the lower one is not read. `again` makes the same R again, because R
    /// is released when panels are packed. reduce: makes a ReducedInverse from R, one call at a
    /// time. It may be empty, and may throw what its poll throws.
    InverseFactor(Eigen::MatrixXd R, Again again, Reduce reduce = {});

    /// Packs the given F of a sparse process. Single precision is compared with |F k|² in double
    /// precision.
    explicit InverseFactor(GivenInverse given);

    int rows() const { return rows_; }
    const double* panels(const Poll& poll = {}) const;
    const Single& single(const Poll& poll = {}) const;

private:
    /// The inverse, transposed, with columns k and the values of |T k|² there.
    struct Judged {
        Eigen::MatrixXd inverse, columns;
        Eigen::VectorXd squares;
    };
    std::optional<Single> reduced(const Eigen::MatrixXd& R, const Poll& poll) const;
    Single full(const Judged& from, const Poll& poll) const;
    Eigen::MatrixXd computeFactor(const Poll& poll) const;
    Judged judgedGiven(const Poll& poll) const;
    static Judged judged(Eigen::MatrixXd R, const Poll& poll);
    Eigen::MatrixXd inverse(const Poll& poll) const;

    int rows_;
    std::optional<GivenInverse> given_;
    Again again_;
    Reduce reduce_;
    mutable PolledMutex mutex_;  // guards everything below; values never change once made
    mutable std::optional<Eigen::MatrixXd> R_;
    mutable std::optional<AlignedArray<double>> double_;
    mutable std::optional<Single> single_;
};

}  // namespace terratact
