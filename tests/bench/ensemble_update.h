#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace terratact {

/// Readings, and what each member of an ensemble predicts of them.
struct EnsembleReadings {
    Eigen::MatrixXd predicted;  ///< readings × members, without noise
    Eigen::VectorXd measured;
    Eigen::VectorXd sd;  ///< of the independent errors of `measured`, above 0
};

/// Returns every column less the mean of all columns.
inline Eigen::MatrixXd anomalies(const Eigen::MatrixXd& members)
{
    const Eigen::VectorXd mean = members.rowwise().mean();
    return members.colwise() - mean;
}

/// Returns normal noise of these sd, of mean 0 over the members.
inline Eigen::MatrixXd centredNoise(const Eigen::VectorXd& sd, Eigen::Index members,
                                    std::mt19937_64& rng)
{
    std::normal_distribution<double> standard;
    Eigen::MatrixXd noise(sd.size(), members);
    for (double& value : noise.reshaped()) value = standard(rng);
    return anomalies(sd.asDiagonal() * noise);
}

/// Updates an ensemble by readings: the ensemble Kalman filter with perturbed observations. Of a
/// state x (one column per member) with predictions h, covariances P over the members, and
/// R = diag(sd²):
///   x̄ ← x̄ + t ∘ K (measured − h̄),  x' ← x' + (1 − relaxation) t ∘ K (e − h'),  K = P_xh (P_hh + R)⁻¹
/// e: noise of each member. t (taper, one number per row): localises; 1 everywhere is the plain
/// filter. relaxation (0 … 1): inflates; it is the share of the prior's anomalies that stays.
/// Sources: Burgers, van Leeuwen & Evensen, Mon. Weather Rev. 126 (1998); relaxation: Zhang, Snyder
/// & Sun, Mon. Weather Rev. 132 (2004).
inline void updateEnsemble(Eigen::MatrixXd& state, const EnsembleReadings& readings,
                           const Eigen::VectorXd& taper, double relaxation, std::mt19937_64& rng)
{
    const Eigen::MatrixXd h = anomalies(readings.predicted);
    Eigen::MatrixXd innovation =
        (1.0 - relaxation) * (centredNoise(readings.sd, state.cols(), rng) - h);
    const Eigen::VectorXd mean = readings.predicted.rowwise().mean();
    innovation.colwise() += readings.measured - mean;
    const double scale = 1.0 / static_cast<double>(state.cols() - 1);
    Eigen::MatrixXd covariance = scale * h * h.transpose();
    covariance.diagonal() += readings.sd.cwiseAbs2();
    const Eigen::MatrixXd cross = scale * anomalies(state) * h.transpose();
    state += taper.asDiagonal() * (cross * covariance.llt().solve(innovation));
}

/// Returns the taper of a distance: 1 at 0, 0 from 2 `reach` on, and about 0.2 at `reach`. Source:
/// Gaspari & Cohn, Q. J. R. Meteorol. Soc. 125 (1999), eq. 4.10.
inline double taperAt(double distance, double reach)
{
    const double r = std::abs(distance) / reach;
    const double r2 = r * r;
    const double r3 = r2 * r;
    if (r < 1.0) return -0.25 * r2 * r3 + 0.5 * r2 * r2 + 0.625 * r3 - 5.0 / 3.0 * r2 + 1.0;
    if (r < 2.0)
        return r2 * r3 / 12.0 - 0.5 * r2 * r2 + 0.625 * r3 + 5.0 / 3.0 * r2 - 5.0 * r + 4.0
             - 2.0 / (3.0 * r);
    return 0.0;
}

}  // namespace terratact
