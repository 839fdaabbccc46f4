#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/learn/kernels/hyperparameters.h"

namespace terratact {

/// Rows of a Gaussian process and its hyperparameters.
struct ProcessData {
    Eigen::MatrixXd X;
    Eigen::VectorXd y;
    Hyperparameters hyper;
};

/// Returns U rows of d standard normal inputs; the output is a sine of the first input with noise.
inline ProcessData someData(int U, int d, unsigned seed = 1)
{
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> normal;
    ProcessData data{Eigen::MatrixXd(U, d), Eigen::VectorXd(U), {}};
    for (double& x : data.X.reshaped()) x = normal(rng);
    for (int u = 0; u < U; ++u) data.y[u] = std::sin(data.X(u, 0)) + 0.1 * normal(rng);
    data.hyper.lengthScale = Eigen::VectorXd::LinSpaced(d, 0.7, 2.5);
    data.hyper.signalSd = 0.9;
    data.hyper.noiseSd = 0.15;
    return data;
}

/// Returns the inverse of a symmetric positive definite matrix from its factor.
template <class Scalar>
Eigen::MatrixX<Scalar> inverseOf(const Eigen::LLT<Eigen::MatrixX<Scalar>>& factor)
{
    return factor.solve(Eigen::MatrixX<Scalar>::Identity(factor.rows(), factor.cols()));
}

/// Returns the squared exponential covariance of two rows.
inline double kernel(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Hyperparameters& h)
{
    return h.signalSd * h.signalSd
         * std::exp(-0.5 * (a - b).cwiseQuotient(h.lengthScale).squaredNorm());
}

/// Returns the covariance of all rows, noise included.
inline Eigen::MatrixXd covariance(const ProcessData& data)
{
    const Eigen::Index U = data.X.rows();
    Eigen::MatrixXd K(U, U);
    for (Eigen::Index i = 0; i < U; ++i)
        for (Eigen::Index j = 0; j < U; ++j)
            K(i, j) = kernel(data.X.row(i), data.X.row(j), data.hyper)
                    + (i == j ? data.hyper.noiseSd * data.hyper.noiseSd : 0.0);
    return K;
}

}  // namespace terratact
