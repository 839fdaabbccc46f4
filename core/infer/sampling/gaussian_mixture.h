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

    /// Conditions the mixture exactly on a measurement z of coordinate i with Gaussian error:
    ///   weight_k ∝ weight_k N(z; mean_ki, C_ii + sd²),  mean_k += C_·i (z − mean_ki) / (C_ii + sd²),
    ///   C −= C_·i C_i· / (C_ii + sd²)
    /// Throws std::invalid_argument unless z is finite and sd is positive.
    void condition(int i, double z, double sd);

    /// Returns the distance of a measurement from the nearest component, in standard deviations:
    ///   min_k |z − mean_ki| / √(C_ii + sd²)
    double surprise(int i, double z, double sd) const;

    /// Returns the logarithm of the density of a measurement of coordinate i with Gaussian error:
    ///   ln Σ_k weight_k N(z; mean_ki, C_ii + sd²)
    double logDensity(int i, double z, double sd) const;

    /// Returns one Gaussian with the mixture's mean and covariance.
    GaussianMixture collapsed() const;

    /// Returns x with P(y_i ≤ x) = p, to 1e-9 of the coordinate's spread. Throws unless 0 < p < 1.
    double quantile(int i, double p) const;

    /// Passes `count` draws of n numbers to `keep`, one after the other. Systematic resampling
    /// gives each component its share of draws. poll: called now and then.
    void draw(int count, std::mt19937_64& rng,
              const std::function<void(const Eigen::VectorXd&)>& keep, const Poll& poll) const;
    /// Returns these draws as a matrix, n × count.
    Eigen::MatrixXd draw(int count, std::mt19937_64& rng) const;
};

}  // namespace terratact
