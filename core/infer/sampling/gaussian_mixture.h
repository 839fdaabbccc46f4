#pragma once

#include <Eigen/Core>
#include <functional>
#include <random>

#include "core/base/poll.h"

namespace terratact {

/// p(y) = Σ_k weight_k N(y; mean_k, covariance): K Gaussians in n dimensions with one covariance.
struct GaussianMixture {
    Eigen::VectorXd weight;      ///< K, sum 1
    Eigen::MatrixXd mean;        ///< n × K
    Eigen::MatrixXd covariance;  ///< n × n, positive semi-definite

    /// Conditions on a measurement z of coordinate i with Gaussian error: exact.
    ///   weight_k ∝ weight_k N(z; mean_ki, C_ii + sd²),  mean_k += C_·i (z − mean_ki) / (C_ii + sd²),
    ///   C −= C_·i C_i· / (C_ii + sd²)
    /// Throws std::invalid_argument unless z is finite and sd positive.
    void condition(int i, double z, double sd);

    /// How many standard deviations a measurement lies from the component that expects it most:
    ///   min_k |z − mean_ki| / √(C_ii + sd²)
    double surprise(int i, double z, double sd) const;

    /// One Gaussian with the mixture's mean and covariance.
    GaussianMixture collapsed() const;

    /// P(y_i ≤ x).
    double cdf(int i, double x) const;

    /// x with P(y_i ≤ x) = p, to 1e-9 of the coordinate's spread.  Throws unless 0 < p < 1.
    double quantile(int i, double p) const;

    /// count draws, one after the other to `keep` (n numbers), the components in proportion to their weights (systematic
    /// resampling).  poll: now and then.
    void draw(int count, std::mt19937_64& rng,
              const std::function<void(const Eigen::VectorXd&)>& keep, const Poll& poll) const;
    /// The same, n × count.
    Eigen::MatrixXd draw(int count, std::mt19937_64& rng) const;
};

}  // namespace terratact
