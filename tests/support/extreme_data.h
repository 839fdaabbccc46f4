#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <sstream>
#include <string>

#include "core/learn/kernels/hyperparameters.h"
#include "tests/support/process_data.h"

namespace terratact {

/// Extreme data for Gaussian processes, with their formulas in long double (64 bits of mantissa).
using Long = long double;
using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;

struct ExtremeData {
    Eigen::MatrixXd X;
    Eigen::VectorXd y;
    Hyperparameters hyper;
};

enum class Kind { Plain, DoubledRows, Collinear, ConstantColumn, OneRowOnly };
inline constexpr Kind kKinds[] = {Kind::Plain, Kind::DoubledRows, Kind::Collinear,
                                  Kind::ConstantColumn, Kind::OneRowOnly};

/// Returns U rows of three inputs.
inline ExtremeData dataOf(Kind kind, int U, double length, double signal, double noise)
{
    std::mt19937_64 rng(7);
    std::normal_distribution<double> normal;
    ExtremeData data{Eigen::MatrixXd(U, 3), Eigen::VectorXd(U), {}};
    for (double& x : data.X.reshaped()) x = normal(rng);
    if (kind == Kind::DoubledRows)
        for (int u = 1; u < U; u += 2) data.X.row(u) = data.X.row(u - 1);
    if (kind == Kind::Collinear) data.X.col(1) = 2.0 * data.X.col(0);
    if (kind == Kind::ConstantColumn) data.X.col(1).setConstant(4.0);
    if (kind == Kind::OneRowOnly) data.X.rowwise() = Eigen::RowVector3d(0.3, -1.0, 2.0);
    for (int u = 0; u < U; ++u) data.y[u] = std::sin(data.X(u, 0)) + 0.1 * normal(rng);
    data.hyper = {Eigen::VectorXd::Constant(3, length), signal, noise};
    return data;
}

/// Returns the data with one more row that resembles no other.
inline ExtremeData withFarRow(ExtremeData data)
{
    const Eigen::Index U = data.X.rows();
    data.X.conservativeResize(U + 1, Eigen::NoChange);
    data.X.row(U) << 1e200, 0.0, 0.0;
    data.y.conservativeResize(U + 1);
    data.y[U] = 5.0;
    return data;
}

/// Calls what(data, its name) for all realistic scales of data, and some unrealistic ones.
inline void forEveryScale(Kind kind, int U,
                          const std::function<void(const ExtremeData&, const std::string&)>& what)
{
    for (const double length : {1e-8, 1e-3, 1.0, 1e3, 1e8})
        for (const double signal : {1e-12, 0.3, 1e6})
            for (const double noise : {0.0, 1e-12, 1e-3, 1e6}) {
                std::ostringstream name;
                name << U << " rows, l " << length << ", sf " << signal << ", sn " << noise;
                what(dataOf(kind, U, length, signal, noise), name.str());
            }
}

/// Returns TERRATACT_ROWS, or `usual`: the number of rows of a large test.
inline int manyRows(int usual)
{
    const char* const wanted = std::getenv("TERRATACT_ROWS");
    return wanted ? std::stoi(wanted) : usual;
}

inline Long squareOf(Long x)
{
    return x * x;
}

/// Returns k(X, x).
inline LongVector covarianceWith(const Eigen::MatrixXd& X, const Eigen::VectorXd& x,
                                 const Hyperparameters& hyper)
{
    const LongVector scale = hyper.lengthScale.cast<Long>();
    LongVector k(X.rows());
    for (Eigen::Index u = 0; u < k.size(); ++u) {
        const LongVector z =
            (X.row(u).transpose().cast<Long>() - x.cast<Long>()).cwiseQuotient(scale);
        k[u] = squareOf(hyper.signalSd) * std::exp(-0.5L * z.squaredNorm());
    }
    return k;
}

/// Returns k(A, B).
inline LongMatrix covarianceOf(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                               const Hyperparameters& hyper)
{
    LongMatrix K(A.rows(), B.rows());
    for (Eigen::Index j = 0; j < B.rows(); ++j)
        K.col(j) = covarianceWith(A, B.row(j).transpose(), hyper);
    return K;
}

/// Returns the reciprocal condition number of a symmetric matrix in the 1-norm; 0 if the inverse
/// overflows.
inline double rcondOf(const LongMatrix& K)
{
    const auto norm = [](const LongMatrix& M) { return M.cwiseAbs().colwise().sum().maxCoeff(); };
    const Eigen::LLT<LongMatrix> factor(K);
    if (factor.info() != Eigen::Success) return 0.0;
    const LongMatrix inverse = inverseOf(factor);
    return inverse.allFinite() ? static_cast<double>(1.0L / (norm(K) * norm(inverse))) : 0.0;
}

}  // namespace terratact
