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

/// A triangle that is inverse already, and covariances to judge single precision at.
struct GivenInverse {
    Eigen::MatrixXd transposed;  ///< Fᵀ: U × U, upper triangle
    Eigen::MatrixXd probes;      ///< U × InverseFactor::kProbes, full columns
};

/// What may take the place of L⁻¹ in single precision: |F k_m|² of some rows k_m of k, and what to judge it at.
struct ReducedInverse {
    std::vector<int> order;  ///< k's rows: first the m that F needs, in its order, then the others
    Eigen::MatrixXd transposed;  ///< Fᵀ: m × m, upper triangle
    Eigen::MatrixXd probes;      ///< m × InverseFactor::kProbes: k_m
    Eigen::VectorXd squares;     ///< |L⁻¹k|² of the probes
    Eigen::VectorXd weights;     ///< of the probes: what a difference from that counts
    double mostError = 0.0;      ///< F is not used where the largest difference counts more
};

/// L⁻¹ of K = L Lᵀ, U × U, packed in panels for CovarianceKernels when it is first needed, in the precision that
/// is needed: U² / 2 numbers each, or m² / 2 of a ReducedInverse.  Safe to share between threads; one that waits for another's packing polls, too.
/// What a poll throws leaves the packing to the next caller.
///
/// Single precision changes |L⁻¹k|² by about ε Σ_i |v_i| Σ_j |L⁻¹_ij k_j|, ε = 6e-8, and the products grow with
/// the condition of K.  The error is therefore measured, at columns of K itself, where |L⁻¹ K e_i|² = K_ii is
/// known: Single::error.  A GivenInverse is compared with itself in double at its probes.  Where there is a
/// ReducedInverse, single precision goes through that, and the error is measured at its probes.
class InverseFactor {
public:
    static constexpr int kProbes = 2 * kGroup;  ///< columns that single precision is judged at
    /// The p-th of kProbes among `count`, from the first to the last.
    static Eigen::Index probe(Eigen::Index p, Eigen::Index count)
    {
        return p * (count - 1) / (kProbes - 1);
    }

    /// In single precision.
    struct Single {
        std::vector<int> order;      ///< k's rows, those that the panels are multiplied with first
        int kept = 0;                ///< how many of them that is: all but where they are reduced
        AlignedArray<float> panels;  ///< kept × kept
        /// Largest difference of |L⁻¹k|² from what it should be, over kProbes columns: K e_i for rows i from the first to
        /// the last, or those of GivenInverse; at least 2⁻²³ of the largest.  Of |F k_m|²: at the probes of
        /// ReducedInverse, each times its weight.
        double error = 0.0;
    };
    using Again = std::function<Eigen::MatrixXd(const Poll&)>;
    using Reduce =
        std::function<std::optional<ReducedInverse>(const Eigen::MatrixXd& R, const Poll&)>;

    /// R = Lᵀ, upper triangle (the lower one is not read); `again` makes the same R once more, for R is given
    /// up when panels are packed.  reduce: from R, called at most once at a time; may be empty, and throw what
    /// its poll throws.
    InverseFactor(Eigen::MatrixXd R, Again again, Reduce reduce = {});

    /// Packs F of a sparse process as it is; compared with |F k|² in double precision.
    explicit InverseFactor(GivenInverse given);

    int rows() const { return rows_; }
    const double* panels(const Poll& poll = {}) const;
    const Single& single(const Poll& poll = {}) const;

private:
    /// The inverse, transposed, with columns k and what |T k|² is there.
    struct Judged {
        Eigen::MatrixXd inverse, columns;
        Eigen::VectorXd squares;
    };
    std::optional<Single> reduced(const Eigen::MatrixXd& R, const Poll& poll) const;
    Single full(const Judged& from, const Poll& poll) const;
    Eigen::MatrixXd takeFactor(const Poll& poll) const;
    Judged judgedGiven(const Poll& poll) const;
    static Judged judged(Eigen::MatrixXd R, const Poll& poll);
    Eigen::MatrixXd inverse(const Poll& poll) const;

    int rows_;
    std::optional<GivenInverse> given_;
    Again again_;
    Reduce reduce_;
    mutable PolledMutex mutex_;  // of everything below; the values never change once there
    mutable std::optional<Eigen::MatrixXd> R_;
    mutable std::optional<AlignedArray<double>> double_;
    mutable std::optional<Single> single_;
};

}  // namespace terratact
