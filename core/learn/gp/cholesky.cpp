#include "core/learn/gp/cholesky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/learn/kernels/blas.h"

namespace terratact {

namespace {

constexpr int kBlock = 128;
constexpr int kVectorBlock = 1024;  // its square is kMaxRead

int size(const Eigen::MatrixXd& A)
{
    return static_cast<int>(A.rows());
}

/// Returns the number of columns between two polls. Each takes a product of kBlock × inner and a
/// triangle of kBlock rows.
int columnsAtOnce(int inner)
{
    return std::max(1, static_cast<int>(kMaxMultiplications / (kBlock * (0.5 * kBlock + inner))));
}

/// Computes rows first … first + rows of R, right of the diagonal block, from the rows above them.
void solveRow(Eigen::MatrixXd& K, int first, int rows, const Poll& poll)
{
    const int n = size(K);
    const int step = columnsAtOnce(first);
    for (int c = first + rows; c < n; c += step) {
        const int columns = std::min(step, n - c);
        callPoll(poll);
        blas(cblas_dgemm, CblasColMajor, CblasTrans, CblasNoTrans, rows, columns, first, -1.0,
             &K(0, first), n, &K(0, c), n, 1.0, &K(first, c), n);
        blas(cblas_dtrsm, CblasColMajor, CblasLeft, CblasUpper, CblasTrans, CblasNonUnit, rows,
             columns, 1.0, &K(first, first), n, &K(first, c), n);
    }
}

/// Calls work(first row, number of rows) for every block of kVectorBlock rows.
template <class Work>
void forBlocks(int from, int to, Work work)
{
    for (int first = from; first < to; first += kVectorBlock)
        work(first, std::min(kVectorBlock, to - first));
}

/// Solves for a block's rows of y with its own triangle.
void solveBlock(const Eigen::MatrixXd& R, CBLAS_TRANSPOSE side, int first, int rows,
                Eigen::VectorXd& y, const Poll& poll)
{
    callPoll(poll);
    blas(cblas_dtrsm, CblasColMajor, CblasLeft, CblasUpper, side, CblasNonUnit, rows, 1, 1.0,
         &R(first, first), size(R), &y[first], size(R));
}

/// y := R⁻ᵀ y
void solveForward(const Eigen::MatrixXd& R, Eigen::VectorXd& y, const Poll& poll)
{
    const int n = size(R);
    forBlocks(0, n, [&](int first, int rows) {
        forBlocks(0, first, [&](int above, int height) {
            callPoll(poll);
            blas(cblas_dgemv, CblasColMajor, CblasTrans, height, rows, -1.0, &R(above, first), n,
                 &y[above], 1, 1.0, &y[first], 1);
        });
        solveBlock(R, CblasTrans, first, rows, y, poll);
    });
}

/// y := R⁻¹ y
void solveBackward(const Eigen::MatrixXd& R, Eigen::VectorXd& y, const Poll& poll)
{
    const int n = size(R);
    for (int first = (n - 1) / kVectorBlock * kVectorBlock; first >= 0; first -= kVectorBlock) {
        const int rows = std::min(kVectorBlock, n - first);
        forBlocks(first + rows, n, [&](int right, int width) {
            callPoll(poll);
            blas(cblas_dgemv, CblasColMajor, CblasNoTrans, rows, width, -1.0, &R(first, right), n,
                 &y[right], 1, 1.0, &y[first], 1);
        });
        solveBlock(R, CblasNoTrans, first, rows, y, poll);
    }
}

}  // namespace

// Works by block rows: R_kk from K_kk − Σ_p R_pkᵀ R_pk, then R_kj = R_kk⁻ᵀ (K_kj − Σ_p R_pkᵀ R_pj).
bool choleskyUpper(Eigen::MatrixXd& K, const Poll& poll)
{
    const int n = size(K);
    for (int first = 0; first < n; first += kBlock) {
        const int rows = std::min(kBlock, n - first);
        callPoll(poll);
        blas(cblas_dsyrk, CblasColMajor, CblasUpper, CblasTrans, rows, first, -1.0, &K(0, first), n,
             1.0, &K(first, first), n);
        const int info =
            blas(LAPACKE_dpotrf_work, LAPACK_COL_MAJOR, 'U', rows, &K(first, first), n);
        if (info != 0) return false;
        solveRow(K, first, rows, poll);
    }
    return K.diagonal().allFinite();  // dpotrf reports no error for a NaN
}

// Works by block columns, from the left: X_0j = −X_00 R_0j X_jj, where X_00 is already inverted.
void invertUpper(Eigen::MatrixXd& R, const Poll& poll)
{
    const int n = size(R);
    for (int first = 0; first < n; first += kBlock) {
        const int columns = std::min(kBlock, n - first);
        for (int r = 0; r < first; r += kBlock) {
            callPoll(poll);
            blas(cblas_dtrmm, CblasColMajor, CblasLeft, CblasUpper, CblasNoTrans, CblasNonUnit,
                 kBlock, columns, 1.0, &R(r, r), n, &R(r, first), n);
            const int right = r + kBlock;
            const int step = columnsAtOnce(first - right);
            for (int c = 0; right < first && c < columns; c += step) {
                callPoll(poll);
                blas(cblas_dgemm, CblasColMajor, CblasNoTrans, CblasNoTrans, kBlock,
                     std::min(step, columns - c), first - right, 1.0, &R(r, right), n,
                     &R(right, first + c), n, 1.0, &R(r, first + c), n);
            }
        }
        callPoll(poll);
        blas(cblas_dtrsm, CblasColMajor, CblasRight, CblasUpper, CblasNoTrans, CblasNonUnit, first,
             columns, -1.0, &R(first, first), n, &R(0, first), n);
        blas(LAPACKE_dtrtri_work, LAPACK_COL_MAJOR, 'U', 'N', columns, &R(first, first), n);
    }
}

void solveWithFactor(const Eigen::MatrixXd& R, Eigen::VectorXd& y, const Poll& poll)
{
    solveForward(R, y, poll);
    solveBackward(R, y, poll);
}

void multiplyTransposed(const Eigen::MatrixXd& U, Eigen::MatrixXd& B, const Poll& poll)
{
    const int n = size(U);
    const auto columns = static_cast<int>(B.cols());
    for (int first = (n - 1) / kVectorBlock * kVectorBlock; first >= 0; first -= kVectorBlock) {
        const int rows = std::min(kVectorBlock, n - first);
        callPoll(poll);
        blas(cblas_dtrmm, CblasColMajor, CblasLeft, CblasUpper, CblasTrans, CblasNonUnit, rows,
             columns, 1.0, &U(first, first), n, &B(first, 0), n);
        forBlocks(0, first, [&](int above, int height) {
            callPoll(poll);
            blas(cblas_dgemm, CblasColMajor, CblasTrans, CblasNoTrans, rows, columns, height, 1.0,
                 &U(above, first), n, &B(above, 0), n, 1.0, &B(first, 0), n);
        });
    }
}

void solveTransposed(const Eigen::MatrixXd& R, Eigen::MatrixXd& B, const Poll& poll)
{
    const int n = size(R);
    const auto columns = static_cast<int>(B.cols());
    forBlocks(0, n, [&](int first, int rows) {
        forBlocks(0, first, [&](int above, int height) {
            callPoll(poll);
            blas(cblas_dgemm, CblasColMajor, CblasTrans, CblasNoTrans, rows, columns, height, -1.0,
                 &R(above, first), n, &B(above, 0), n, 1.0, &B(first, 0), n);
        });
        callPoll(poll);
        blas(cblas_dtrsm, CblasColMajor, CblasLeft, CblasUpper, CblasTrans, CblasNonUnit, rows,
             columns, 1.0, &R(first, first), n, &B(first, 0), n);
    });
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
        blas(LAPACKE_dlacn2_work, n, v.data(), x.data(), sign.data(), &inverseNorm, &next,
             memory.data());
        if (next == 0) break;
        solveWithFactor(R, x, poll);  // K⁻¹ is symmetric, so this is also K⁻ᵀ
        if (!x.allFinite()) return 0.0;
    }
    return 1.0 / (norm * inverseNorm);
}

double symmetricNorm(const Eigen::MatrixXd& K, const Poll& poll)
{
    PolledWork work(poll);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(K.cols());
    for (Eigen::Index j = 0; j < K.cols(); ++j) {
        work.done(j);
        sum.head(j) += K.col(j).head(j).cwiseAbs();
        sum[j] += K.col(j).head(j + 1).lpNorm<1>();
    }
    return sum.maxCoeff();  // the factorisation detects NaN
}

}  // namespace terratact
