#include "core/learn/gp/inverse_factor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/learn/kernels/covariance_kernels.h"
#include "core/learn/kernels/kernel_poll.h"

namespace terratact {

namespace {

constexpr int kProbes = InverseFactor::kProbes;

/// Packs rows of the lower triangle L⁻¹ = (R⁻¹)ᵀ in panels.
template <class T>
AlignedArray<T> pack(const Eigen::MatrixXd& inverseR, const Poll& poll)
{
    constexpr int kRows = kPanelRows<T>;
    const auto U = static_cast<int>(inverseR.rows());
    AlignedArray<T> panels(static_cast<std::size_t>(panelStart<T>(paddedRows(U))), Unset{});
    for (int first = 0; first < paddedRows(U); first += kRows) {
        callPoll(poll);
        std::fill(panels.data() + panelStart<T>(first),
                  panels.data() + panelStart<T>(first + kRows), T{});
    }
    for (int i = 0; i < U; ++i) {
        const int first = i / kRows * kRows;
        if (i == first) callPoll(poll);
        T* out = panels.data() + panelStart<T>(first) + (i - first);
        const double* row = inverseR.data() + static_cast<Eigen::Index>(i) * U;
        for (int j = 0; j <= i; ++j) out[static_cast<long>(j) * kRows] = static_cast<T>(row[j]);
    }
    return panels;
}

/// Returns K e_i = Rᵀ R e_i for the rows at which it is judged: U × kProbes.
Eigen::MatrixXd probeColumns(const Eigen::MatrixXd& R, const Poll& poll)
{
    const Eigen::Index U = R.rows();
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(U, kProbes);
    for (int p = 0; p < kProbes; ++p) {
        const Eigen::Index i = InverseFactor::probe(p, U);
        columns.col(p).head(i + 1) = R.col(i).head(i + 1);
    }
    multiplyTransposed(R, columns, poll);
    return columns;
}

/// Returns |T k|² of every column k, from Tᵀ.
Eigen::VectorXd squaresOf(const Eigen::MatrixXd& transposed, Eigen::MatrixXd columns,
                          const Poll& poll)
{
    multiplyTransposed(transposed, columns, poll);
    return columns.colwise().squaredNorm();
}

/// Returns the differences of |panels · k|² from the expected values; infinite if one is not a
/// number.
Eigen::VectorXd errorsAt(const Eigen::MatrixXd& columns, const Eigen::VectorXd& expected,
                         const AlignedArray<float>& panels, const Poll& poll)
{
    const auto U = static_cast<int>(columns.rows());
    const long block = static_cast<long>(paddedRows(U)) * kGroup;
    AlignedArray<float> K(static_cast<std::size_t>(block) * kProbes / kGroup);
    AlignedArray<double> squares(kProbes);
    for (int p = 0; p < kProbes; ++p)
        for (int u = 0; u < U; ++u)
            K.data()[p / kGroup * block + static_cast<long>(u) * kGroup + p % kGroup] =
                static_cast<float>(columns(u, p));
    covarianceKernels().sumsOfSquaresSingle(panels.data(), K.data(), U, kProbes / kGroup,
                                            squares.data(), kernelPoll(poll));
    Eigen::VectorXd errors(kProbes);
    for (int p = 0; p < kProbes; ++p) {
        const double difference = std::abs(squares.data()[p] - expected[p]);
        errors[p] =
            std::isfinite(difference) ? difference : std::numeric_limits<double>::infinity();
    }
    return errors;
}

/// Returns the largest error, at least one rounding: with few rows all probes may be more accurate
/// than other columns.
double largestError(const Eigen::VectorXd& errors, const Eigen::VectorXd& expected)
{
    return std::max(errors.maxCoeff(), std::numeric_limits<float>::epsilon() * expected.maxCoeff());
}

}  // namespace

InverseFactor::InverseFactor(Eigen::MatrixXd R, Again again, Reduce reduce)
    : rows_(static_cast<int>(R.rows())), again_(std::move(again)), reduce_(std::move(reduce)),
      R_(std::move(R))
{
}

InverseFactor::InverseFactor(GivenInverse given)
    : rows_(static_cast<int>(given.transposed.rows())), given_(std::move(given))
{
}

Eigen::MatrixXd InverseFactor::computeFactor(const Poll& poll) const
{
    if (!R_) return again_(poll);
    Eigen::MatrixXd R = std::move(*R_);
    R_.reset();
    return R;
}

Eigen::MatrixXd InverseFactor::inverse(const Poll& poll) const
{
    if (given_) return given_->transposed;
    Eigen::MatrixXd R = computeFactor(poll);
    invertUpper(R, poll);
    return R;
}

InverseFactor::Judged InverseFactor::judgedGiven(const Poll& poll) const
{
    return {given_->transposed, given_->probes,
            squaresOf(given_->transposed, given_->probes, poll)};
}

InverseFactor::Judged InverseFactor::judged(Eigen::MatrixXd R, const Poll& poll)
{
    Judged judged{std::move(R), {}, Eigen::VectorXd(kProbes)};
    judged.columns = probeColumns(judged.inverse, poll);
    for (int p = 0; p < kProbes; ++p)
        judged.squares[p] = judged.columns(probe(p, judged.columns.rows()), p);
    invertUpper(judged.inverse, poll);
    return judged;
}

const double* InverseFactor::panels(const Poll& poll) const
{
    const PolledMutex::Lock lock(mutex_, poll);
    if (!double_) double_ = pack<double>(inverse(poll), poll);
    return double_->data();
}

/// Returns nothing if there is nothing to reduce, or if the result is not good enough.
std::optional<InverseFactor::Single> InverseFactor::reduced(const Eigen::MatrixXd& R,
                                                            const Poll& poll) const
{
    if (!reduce_) return std::nullopt;
    std::optional<ReducedInverse> reduced = reduce_(R, poll);
    if (!reduced) return std::nullopt;
    AlignedArray<float> panels = pack<float>(reduced->transposed, poll);
    const double error = errorsAt(reduced->probes, reduced->squares, panels, poll)
                             .cwiseProduct(reduced->weights)
                             .maxCoeff();
    if (!(error <= reduced->mostError)) return std::nullopt;
    return Single{std::move(reduced->order), static_cast<int>(reduced->transposed.rows()),
                  std::move(panels), error};
}

InverseFactor::Single InverseFactor::full(const Judged& from, const Poll& poll) const
{
    Single single{std::vector<int>(static_cast<std::size_t>(rows_)), rows_,
                  pack<float>(from.inverse, poll), 0.0};
    std::iota(single.order.begin(), single.order.end(), 0);
    single.error =
        largestError(errorsAt(from.columns, from.squares, single.panels, poll), from.squares);
    return single;
}

const InverseFactor::Single& InverseFactor::single(const Poll& poll) const
{
    const PolledMutex::Lock lock(mutex_, poll);
    if (single_) return *single_;
    if (given_) {
        single_ = full(judgedGiven(poll), poll);
    } else {
        Eigen::MatrixXd R = computeFactor(poll);
        single_ = reduced(R, poll);
        if (!single_) single_ = full(judged(std::move(R), poll), poll);
    }
    return *single_;
}

}  // namespace terratact
