#include "core/learn/gp/inducing_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "core/learn/gp/cholesky.h"
#include "core/learn/kernels/blas.h"
#include "core/learn/kernels/blas_size.h"
#include "core/learn/kernels/covariance_kernels.h"

namespace terratact {

namespace {

constexpr int kMaxAhead = 48;

/// Covariances that the chosen rows leave, and the columns of the likely next rows. These columns
/// are computed together, because one column at a time would read the whole of V for each.
class Choice {
public:
    Choice(const ScaledRows& X, double signal2, Eigen::Index most)
        : covariances_(X, signal2), variance_(Eigen::VectorXd::Constant(X.X.rows(), signal2)),
          V_(X.X.rows(), most), columns_(X.X.rows(), std::min<Eigen::Index>(kMaxAhead, most))
    {
    }

    double largestVariance() const { return variance_.maxCoeff(); }

    /// Chooses the prepared row with the largest variance if it is good enough, else the best of
    /// all rows.
    void select(double goodEnough, const Poll& poll)
    {
        callPoll(poll);
        auto place = bestAhead();
        if (place == ahead_.end() || variance_[*place] < goodEnough) {
            lookAhead(poll);
            place = ahead_.begin();
        }
        const Eigen::Index next = *place;
        auto column = V_.col(chosen_);
        column = columns_.col(place - ahead_.begin());
        subtract(next, columnsFrom_, column);
        column /= std::sqrt(variance_[next]);
        variance_ -= column.cwiseAbs2();
        variance_[next] = 0.0;
        rows_.push_back(blasSize(next));
        ++chosen_;
        ++taken_;
    }

    InducingRows chosen() &&
    {
        V_.conservativeResize(Eigen::NoChange, chosen_);
        const double left = chosen_ < variance_.size() ? variance_.maxCoeff() : 0.0;
        return {std::move(rows_), std::move(V_), left};
    }

private:
    /// column −= V_.middleCols(from …) V_(row, from …)ᵀ
    void subtract(Eigen::Index row, Eigen::Index from, Eigen::Ref<Eigen::VectorXd> column) const
    {
        if (chosen_ == from) return;
        blas(cblas_dgemv, CblasColMajor, CblasNoTrans, blasSize(V_.rows()),
             blasSize(chosen_ - from), -1.0, &V_(0, from), blasSize(V_.rows()), &V_(row, from),
             blasSize(V_.rows()), 1.0, column.data(), 1);
    }

    std::vector<int>::const_iterator bestAhead() const
    {
        return std::max_element(ahead_.begin(), ahead_.end(),
                                [this](int a, int b) { return variance_[a] < variance_[b]; });
    }

    /// Prepares the rows with the largest variances, largest first: a few more than the last time
    /// were useful.
    void lookAhead(const Poll& poll)
    {
        const Eigen::Index count =
            std::min<Eigen::Index>({taken_ + taken_ / 4 + 2, kMaxAhead, V_.cols() - chosen_});
        ahead_.resize(static_cast<std::size_t>(variance_.size()));
        std::iota(ahead_.begin(), ahead_.end(), 0);
        const auto larger = [this](int a, int b) {
            return variance_[a] != variance_[b] ? variance_[a] > variance_[b] : a < b;
        };
        std::partial_sort(ahead_.begin(), ahead_.begin() + count, ahead_.end(), larger);
        ahead_.resize(static_cast<std::size_t>(count));
        for (std::size_t first = 0; first < ahead_.size(); first += kGroup)
            covariances(first, poll);
        Eigen::MatrixXd ofAhead(count, chosen_);
        PolledWork work(poll);
        for (Eigen::Index k = 0; k < chosen_; ++k) {
            ofAhead.col(k) = V_.col(k)(ahead_);
            work.done(8 * count);  // numbers far apart in memory
        }
        const Eigen::Index step = linesAtOnce(count * chosen_);
        for (Eigen::Index first = 0; chosen_ > 0 && first < V_.rows(); first += step) {
            callPoll(poll);
            blas(cblas_dgemm, CblasColMajor, CblasNoTrans, CblasTrans,
                 blasSize(std::min(step, V_.rows() - first)), blasSize(count), blasSize(chosen_),
                 -1.0, &V_(first, 0), blasSize(V_.rows()), ofAhead.data(), blasSize(count), 1.0,
                 &columns_(first, 0), blasSize(V_.rows()));
        }
        columnsFrom_ = chosen_;
        taken_ = 0;
    }

    /// Computes columns_ of ahead_[first] and up to seven more.
    void covariances(std::size_t first, const Poll& poll)
    {
        callPoll(poll);
        const auto some =
            std::span(ahead_).subspan(first, std::min<std::size_t>(kGroup, ahead_.size() - first));
        const double* block = covariances_.with(some, blasSize(variance_.size()));
        for (std::size_t c = 0; c < some.size(); ++c)
            for (Eigen::Index u = 0; u < variance_.size(); ++u)
                columns_(u, static_cast<Eigen::Index>(first + c)) =
                    block[u * kGroup + static_cast<Eigen::Index>(c)];
    }

    CovarianceBlock covariances_;
    Eigen::VectorXd variance_;  // variance of every row given the chosen ones; 0 for chosen rows
    Eigen::MatrixXd V_;
    std::vector<int> rows_;
    Eigen::Index chosen_ = 0;
    std::vector<int> ahead_;
    // Covariances with ahead_, without what columnsFrom_ columns of V_ explain.
    Eigen::MatrixXd columns_;
    Eigen::Index columnsFrom_ = 0;
    Eigen::Index taken_ = 0;  // number of taken rows of ahead_
};

}  // namespace

InducingRows chooseInducingRows(const ScaledRows& X, double signal2, const RowsWanted& wanted,
                                const Poll& poll)
{
    const Eigen::Index most = std::min(wanted.most, X.X.rows());
    Choice choice(X, signal2, most);
    for (Eigen::Index count = 0; count < most; ++count) {
        const double largest = choice.largestVariance();
        if (!(largest > wanted.leastVariance)) break;
        if (count == most / 2 && largest > wanted.mostHalfway) break;
        choice.select(wanted.share * largest, poll);
    }
    return std::move(choice).chosen();
}

std::vector<int> rowsNotIn(const std::vector<int>& chosen, Eigen::Index rows)
{
    std::vector<bool> in(static_cast<std::size_t>(rows), false);
    for (const int u : chosen) in[static_cast<std::size_t>(u)] = true;
    std::vector<int> others;
    for (int u = 0; u < static_cast<int>(rows); ++u)
        if (!in[static_cast<std::size_t>(u)]) others.push_back(u);
    return others;
}

Eigen::MatrixXd factorOf(const InducingRows& inducing, const Poll& poll)
{
    const auto m = static_cast<Eigen::Index>(inducing.rows.size());
    Eigen::MatrixXd L(m, m);
    PolledWork work(poll);
    for (Eigen::Index k = 0; k < m; ++k) {
        L.col(k).head(k).setZero();
        for (Eigen::Index i = k; i < m; ++i)
            L(i, k) = inducing.V(inducing.rows[static_cast<std::size_t>(i)], k);
        work.done(m);
    }
    return L;
}

}  // namespace terratact
