#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "core/learn/aligned_array.h"
#include "core/learn/cholesky.h"
#include "core/learn/covariance_kernels.h"
#include "core/learn/precision.h"
#include "core/polled_mutex.h"

namespace terratact {

/// A triangle that is inverse already, and covariances to judge single precision at.
struct GivenInverse {
    Eigen::MatrixXd transposed;  ///< Fᵀ: U × U, upper triangle
    Eigen::MatrixXd probes;      ///< U × InverseFactor::kProbes, full columns
};

/// L⁻¹ of K = L Lᵀ, U × U, packed in panels for CovarianceKernels when it is first needed, in the precision that
/// is needed: U² / 2 numbers each.  Safe to share between threads; one that waits for another's packing polls, too.
/// What a poll throws leaves the packing to the next caller.
///
/// Single precision changes |L⁻¹k|² by about ε Σ_i |v_i| Σ_j |L⁻¹_ij k_j|, ε = 6e-8, and the products grow with
/// the condition of K.  The error is therefore measured, at columns of K itself, where |L⁻¹ K e_i|² = K_ii is
/// known: singleError().
class InverseFactor {
public:
    static constexpr int kProbes = 2 * kGroup;  ///< columns that singleError() looks at

    /// R = Lᵀ, upper triangle (the lower one is not read); `again` makes the same R once more, for R is given
    /// up when panels are packed.
    InverseFactor(Eigen::MatrixXd R, std::function<Eigen::MatrixXd(const Poll&)> again);

    /// Packs F of a sparse process as it is; singleError() compares with |F k|² in double precision.
    explicit InverseFactor(GivenInverse given);

    int rows() const { return rows_; }
    const double* panels(const Poll& poll = {}) const;
    const float* panelsSingle(const Poll& poll = {}) const;

    /// Largest | |L⁻¹ K e_i|² − K_ii | in single precision over kProbes rows i from the first to the last, and at least
    /// 2⁻²³ of the largest K_ii.  (Of F: with the probes in place of K e_i.)
    double singleError(const Poll& poll = {}) const;

private:
    /// The inverse, transposed, with columns k and what |T k|² is there.
    struct Judged {
        Eigen::MatrixXd inverse, columns;
        Eigen::VectorXd squares;
    };
    struct Single {
        AlignedArray<float> panels;
        double error = 0.0;
    };
    const Single& single(const Poll& poll) const;
    Eigen::MatrixXd takeFactor(const Poll& poll) const;
    Judged judged(const Poll& poll) const;
    Eigen::MatrixXd inverse(const Poll& poll) const;

    int rows_;
    std::optional<GivenInverse> given_;
    std::function<Eigen::MatrixXd(const Poll&)> again_;
    mutable PolledMutex mutex_;  // of everything below; the values never change once there
    mutable std::optional<Eigen::MatrixXd> R_;
    mutable std::optional<AlignedArray<double>> double_;
    mutable std::optional<Single> single_;
};

}  // namespace terratact
