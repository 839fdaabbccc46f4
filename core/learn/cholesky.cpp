#include "core/learn/cholesky.h"

#include <cblas.h>
#include <lapacke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace terratact {

namespace {

constexpr int kBlock = 128;
constexpr double kMultiplications = 1e8;  // between two polls

void call(const Poll& poll)
{
    if (poll) poll();
}

int size(const Eigen::MatrixXd& A)
{
    return static_cast<int>(A.rows());
}

/// Columns of a product with `inner` × kBlock multiplications each that lie between two polls.
int columnsAtOnce(int inner)
{
    return std::max(kBlock, static_cast<int>(kMultiplications / (kBlock * (1.0 + inner))));
}

/// Rows first … first + rows of R right of the diagonal block, from the rows above them.
void solveRow(Eigen::MatrixXd& K, int first, int rows, const Poll& poll)
{
    const int n = size(K);
    const int step = columnsAtOnce(first);
    for (int c = first + rows; c < n; c += step) {
        const int columns = std::min(step, n - c);
        call(poll);
        cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, rows, columns, first, -1.0,
                    &K(0, first), n, &K(0, c), n, 1.0, &K(first, c), n);
        cblas_dtrsm(CblasColMajor, CblasLeft, CblasUpper, CblasTrans, CblasNonUnit, rows, columns,
                    1.0, &K(first, first), n, &K(first, c), n);
    }
}

/// y := K⁻¹ y.
void solve(const Eigen::MatrixXd& R, Eigen::VectorXd& y, const Poll& poll)
{
    for (const CBLAS_TRANSPOSE side : {CblasTrans, CblasNoTrans}) {
        call(poll);
        cblas_dtrsv(CblasColMajor, CblasUpper, side, CblasNonUnit, size(R), R.data(), size(R),
                    y.data(), 1);
    }
}

}  // namespace

// By block rows: R_kk from K_kk − Σ_p R_pkᵀ R_pk, then R_kj = R_kk⁻ᵀ (K_kj − Σ_p R_pkᵀ R_pj).
bool choleskyUpper(Eigen::MatrixXd& K, const Poll& poll)
{
    const int n = size(K);
    for (int first = 0; first < n; first += kBlock) {
        const int rows = std::min(kBlock, n - first);
        call(poll);
        cblas_dsyrk(CblasColMajor, CblasUpper, CblasTrans, rows, first, -1.0, &K(0, first), n, 1.0,
                    &K(first, first), n);
        const int info = LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'U', rows, &K(first, first), n);
        if (info != 0) return false;
        solveRow(K, first, rows, poll);
    }
    return K.diagonal().allFinite();  // a NaN is no error to dpotrf
}

// By block columns, from the left: X_0j = −X_00 R_0j X_jj, where X_00 is already inverted.
void invertUpper(Eigen::MatrixXd& R, const Poll& poll)
{
    const int n = size(R);
    for (int first = 0; first < n; first += kBlock) {
        const int columns = std::min(kBlock, n - first);
        for (int r = 0; r < first; r += kBlock) {
            call(poll);
            cblas_dtrmm(CblasColMajor, CblasLeft, CblasUpper, CblasNoTrans, CblasNonUnit, kBlock,
                        columns, 1.0, &R(r, r), n, &R(r, first), n);
            const int right = r + kBlock;
            if (right < first)
                cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, kBlock, columns,
                            first - right, 1.0, &R(r, right), n, &R(right, first), n, 1.0,
                            &R(r, first), n);
        }
        call(poll);
        cblas_dtrsm(CblasColMajor, CblasRight, CblasUpper, CblasNoTrans, CblasNonUnit, first,
                    columns, -1.0, &R(first, first), n, &R(0, first), n);
        LAPACKE_dtrtri_work(LAPACK_COL_MAJOR, 'U', 'N', columns, &R(first, first), n);
    }
}

double reciprocalCondition(const Eigen::MatrixXd& R, double norm, const Poll& poll)
{
    const int n = size(R);
    Eigen::VectorXd v(n);
    Eigen::VectorXd x(n);
    std::vector<lapack_int> sign(static_cast<std::size_t>(n));
    std::array<lapack_int, 3> memory{};
    lapack_int next = 0;
    double inverseNorm = 0.0;
    for (;;) {
        LAPACKE_dlacn2_work(n, v.data(), x.data(), sign.data(), &inverseNorm, &next, memory.data());
        if (next == 0) break;
        solve(R, x, poll);  // K⁻¹ is symmetric: the same where K⁻ᵀ is wanted
        if (!x.allFinite()) return 0.0;
    }
    return 1.0 / (norm * inverseNorm);
}

double symmetricNorm(const Eigen::MatrixXd& K)
{
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(K.cols());
    for (Eigen::Index j = 0; j < K.cols(); ++j) {
        sum.head(j) += K.col(j).head(j).cwiseAbs();
        sum[j] += K.col(j).head(j + 1).lpNorm<1>();
    }
    return sum.maxCoeff();  // NaN is for the factorisation to find
}

}  // namespace terratact
