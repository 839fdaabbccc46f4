#include "core/infer/sampling/gaussian_mixture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "core/base/normal.h"
#include "core/base/random_unit.h"
#include "core/infer/sampling/truncated_normal.h"
#include "core/learn/gp/symmetric_eigen.h"

namespace terratact {

namespace {

/// Returns a square root of a positive semi-definite matrix.
Eigen::MatrixXd squareRoot(const Eigen::MatrixXd& covariance)
{
    const SymmetricEigen eigen = symmetricEigen(covariance);
    return eigen.vectors * eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

}  // namespace

void GaussianMixture::condition(int i, double z, double sd)
{
    if (!std::isfinite(z) || !(sd > 0.0))
        throw std::invalid_argument("a measurement must be finite and its sd positive");
    const double variance = covariance(i, i) + sd * sd;
    const Eigen::VectorXd gain = covariance.col(i) / variance;
    const Eigen::ArrayXd surprise = z - mean.row(i).transpose().array();
    // Weights are relative to the nearest component, so that a distant measurement does not make
    // every weight 0.
    const Eigen::ArrayXd exponent =
        weight.array().max(1e-300).log() - 0.5 * surprise.square() / variance;
    weight = (exponent - exponent.maxCoeff()).exp().matrix();
    weight /= weight.sum();
    mean += gain * surprise.matrix().transpose();
    covariance -= gain * covariance.row(i).eval();
    covariance = 0.5 * (covariance + covariance.transpose()).eval();
}

double GaussianMixture::surprise(int i, double z, double sd) const
{
    const double least = (z - mean.row(i).array()).abs().minCoeff();
    return least / std::sqrt(covariance(i, i) + sd * sd);
}

double GaussianMixture::logDensity(int i, double z, double sd) const
{
    const double variance = covariance(i, i) + sd * sd;
    const Eigen::ArrayXd exponent = weight.array().max(1e-300).log()
                                  - 0.5 * (z - mean.row(i).transpose().array()).square() / variance;
    const double most = exponent.maxCoeff();
    return most + std::log((exponent - most).exp().sum())
         - 0.5 * std::log(2.0 * std::numbers::pi * variance);
}

GaussianMixture GaussianMixture::collapsed() const
{
    const Eigen::VectorXd centre = mean * weight;
    const Eigen::MatrixXd spread = mean.colwise() - centre;
    return {Eigen::VectorXd::Ones(1), centre,
            covariance + spread * weight.asDiagonal() * spread.transpose()};
}

double GaussianMixture::quantile(int i, double p) const
{
    if (!(p > 0.0 && p < 1.0))
        throw std::invalid_argument("a quantile needs a probability between 0 and 1");
    const double sd = std::sqrt(std::max(covariance(i, i), 1e-300));
    double low = mean.row(i).minCoeff() - 9.0 * sd;
    double high = mean.row(i).maxCoeff() + 9.0 * sd;
    // The bracket cannot get narrower than the distance of neighbouring doubles.
    const double rounding =
        4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(low), std::abs(high));
    const double exact = std::max(1e-9 * (high - low) + 1e-15, rounding);
    double x = 0.5 * (low + high);
    // Newton's steps, with bisection where a step leaves the bracket.
    while (high - low > exact) {
        double below = 0.0;
        double density = 0.0;
        for (Eigen::Index k = 0; k < weight.size(); ++k) {
            const double z = (x - mean(i, k)) / sd;
            if (z > 9.0)
                below += weight[k];
            else if (z > -9.0) {
                below += weight[k] * normalCdf(z);
                density += weight[k] * std::exp(-0.5 * z * z);
            }
        }
        density /= sd * std::sqrt(2.0 * std::numbers::pi);
        (below < p ? low : high) = x;
        const double step = (p - below) / density;
        const double next = x + step;
        const bool inside = next > low && next < high;
        if (inside && std::abs(step) < exact) return next;
        x = inside ? next : 0.5 * (low + high);
    }
    return x;
}

void GaussianMixture::draw(int count, std::mt19937_64& rng,
                           const std::function<void(const Eigen::VectorXd&)>& keep,
                           const Poll& poll) const
{
    PolledWork work(poll);
    const Eigen::MatrixXd root = squareRoot(covariance);
    const double infinity = std::numeric_limits<double>::infinity();
    const double start = randomUnit(rng);
    Eigen::Index k = 0;
    double sum = weight[0];
    Eigen::VectorXd normal(mean.rows()), drawn(mean.rows());
    for (int d = 0; d < count; ++d) {
        work.done(4 * mean.rows());
        const double target = (static_cast<double>(d) + start) / count;
        while (sum < target && k + 1 < weight.size()) sum += weight[++k];
        for (double& z : normal) z = drawBelow(infinity, 0.0, 1.0, rng);
        drawn = mean.col(k) + root * normal;
        keep(drawn);
    }
}

Eigen::MatrixXd GaussianMixture::draw(int count, std::mt19937_64& rng) const
{
    Eigen::MatrixXd draws(mean.rows(), count);
    Eigen::Index d = 0;
    draw(count, rng, [&](const Eigen::VectorXd& drawn) { draws.col(d++) = drawn; }, {});
    return draws;
}

}  // namespace terratact
