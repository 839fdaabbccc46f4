// Counts the BLAS functions that core calls for large matrices, and calls the library.
#include "tests/support/counted_blas.h"

#include <cblas.h>
#include <dlfcn.h>

#include <atomic>

namespace {

std::atomic<double> multiplications{0.0}, entriesRead{0.0};

void count(double products, double entries)
{
    multiplications += products;
    entriesRead += entries;
}

template <class Function>
Function library(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// Returns the rows of a triangle left or right of an m × n matrix.
double side(CBLAS_SIDE where, int m, int n)
{
    return where == CblasLeft ? m : n;
}

}  // namespace

terratact::BlasWork terratact::blasWork()
{
    return {multiplications, entriesRead};
}

extern "C" {

void cblas_dgemm(CBLAS_ORDER order, CBLAS_TRANSPOSE a, CBLAS_TRANSPOSE b, blasint m, blasint n,
                 blasint k, double alpha, const double* A, blasint lda, const double* B,
                 blasint ldb, double beta, double* C, blasint ldc)
{
    static const auto real = library<decltype(&cblas_dgemm)>("cblas_dgemm");
    count(1.0 * m * n * k, 1.0 * m * k + 1.0 * k * n);
    real(order, a, b, m, n, k, alpha, A, lda, B, ldb, beta, C, ldc);
}

void cblas_dsyrk(CBLAS_ORDER order, CBLAS_UPLO uplo, CBLAS_TRANSPOSE trans, blasint n, blasint k,
                 double alpha, const double* A, blasint lda, double beta, double* C, blasint ldc)
{
    static const auto real = library<decltype(&cblas_dsyrk)>("cblas_dsyrk");
    count(0.5 * n * n * k, 1.0 * n * k);
    real(order, uplo, trans, n, k, alpha, A, lda, beta, C, ldc);
}

void cblas_dtrsm(CBLAS_ORDER order, CBLAS_SIDE where, CBLAS_UPLO uplo, CBLAS_TRANSPOSE trans,
                 CBLAS_DIAG diag, blasint m, blasint n, double alpha, const double* A, blasint lda,
                 double* B, blasint ldb)
{
    static const auto real = library<decltype(&cblas_dtrsm)>("cblas_dtrsm");
    const double rows = side(where, m, n);
    count(0.5 * rows * m * n, 0.5 * rows * rows);
    real(order, where, uplo, trans, diag, m, n, alpha, A, lda, B, ldb);
}

void cblas_dtrmm(CBLAS_ORDER order, CBLAS_SIDE where, CBLAS_UPLO uplo, CBLAS_TRANSPOSE trans,
                 CBLAS_DIAG diag, blasint m, blasint n, double alpha, const double* A, blasint lda,
                 double* B, blasint ldb)
{
    static const auto real = library<decltype(&cblas_dtrmm)>("cblas_dtrmm");
    const double rows = side(where, m, n);
    count(0.5 * rows * m * n, 0.5 * rows * rows);
    real(order, where, uplo, trans, diag, m, n, alpha, A, lda, B, ldb);
}

void cblas_dtrsv(CBLAS_ORDER order, CBLAS_UPLO uplo, CBLAS_TRANSPOSE trans, CBLAS_DIAG diag,
                 blasint n, const double* A, blasint lda, double* x, blasint incx)
{
    static const auto real = library<decltype(&cblas_dtrsv)>("cblas_dtrsv");
    count(0.5 * n * n, 0.5 * n * n);
    real(order, uplo, trans, diag, n, A, lda, x, incx);
}

void cblas_dgemv(CBLAS_ORDER order, CBLAS_TRANSPOSE trans, blasint m, blasint n, double alpha,
                 const double* A, blasint lda, const double* x, blasint incx, double beta,
                 double* y, blasint incy)
{
    static const auto real = library<decltype(&cblas_dgemv)>("cblas_dgemv");
    count(1.0 * m * n, 1.0 * m * n);
    real(order, trans, m, n, alpha, A, lda, x, incx, beta, y, incy);
}

}  // extern "C"
