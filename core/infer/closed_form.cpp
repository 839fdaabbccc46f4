#include "core/infer/closed_form.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/infer/estimate/hazards.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/draw_summary.h"
#include "core/learn/kernels/hyperparameters.h"
#include "core/learn/model/clearance.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {

namespace {

void check(const Settings& settings)
{
    if (!isClosedForm(settings.method))
        throw std::invalid_argument(
            fmt::format("method {} has no closed form", name(settings.method)));
    if (settings.draws < 1 || settings.draws > kMaxDraws)
        throw std::invalid_argument(fmt::format("an estimate needs 1 to {} draws", kMaxDraws));
    if (!(settings.forceThreshold >= 0.0))
        throw std::invalid_argument("the force threshold must be 0 or more");
}

/// Returns the features of s in the order that the model's processes expect.
Eigen::VectorXd featuresFor(const ClearanceModel& model, const Proprioception& s)
{
    const bool enough = (missingFeatures(s) & ~model.without()).none();
    return enough ? knownFeatures(s) : features(FeatureSet::Paf, s);
}

/// Distance in standard deviations beyond which a measurement contradicts all similar training
/// scenes. Only their spread counts then.
constexpr double kSurprised = 2.0;

/// Conditions the distribution of one bin's surface coordinate.
void applyMeasurement(GaussianMixture& distribution, std::size_t bin,
                      const MeasuredHeight& measured, double ceiling)
{
    // A height below the deepest sinking of the robot counts as the deepest sinking.
    const double height = std::min(measured.height, ceiling + kDeepestSinking);
    const double y = toSurface(height, ceiling);
    const double error = std::abs(toSurface(height - measured.sd, ceiling) - y);
    const int i = static_cast<int>(bin);
    if (distribution.surprise(i, y, error) > kSurprised) distribution = distribution.collapsed();
    distribution.condition(i, y, error);
}

void applyMeasurements(GaussianMixture& distribution, MeasuredBins& measured,
                       const ClearanceModel& model, TerrainEstimate& estimate)
{
    for (std::size_t i = 0; i < kBins; ++i) {
        if (!measured.bin[i]) continue;
        MeasuredHeight& height = *measured.bin[i];
        if (height.origin == Origin::Contact)
            height = {height.height + model.contactBias(), model.contactSd(), Origin::Contact};
        applyMeasurement(distribution, i, height, estimate.ceiling[i]);
        estimate.origin[i] = height.origin;
    }
    estimate.warnings = std::move(measured.warnings);
}

/// Writes mean and sd of a bin's height; y is a mixture of Gaussians.
void momentsOf(const GaussianMixture& distribution, std::size_t bin, TerrainEstimate& estimate)
{
    const auto i = static_cast<Eigen::Index>(bin);
    const double variance = distribution.covariance(i, i);
    const Eigen::ArrayXd mean = distribution.mean.row(i).transpose().array();
    const Eigen::ArrayXd weight = distribution.weight.array();
    if (std::isinf(estimate.ceiling[bin])) {
        const double centre = (weight * mean).sum();
        estimate.mean[bin] = centre;
        estimate.sd[bin] = std::sqrt((weight * (mean - centre).square()).sum() + variance);
        return;
    }
    // E sinh y and E sinh² y for a Gaussian y.
    const double first = std::exp(0.5 * variance) * (weight * mean.sinh()).sum();
    const double second =
        0.5 * (std::exp(2.0 * variance) * (weight * (2.0 * mean).cosh()).sum() - 1.0);
    estimate.mean[bin] = estimate.ceiling[bin] - std::max(kSurfaceScale * first, -kDeepestSinking);
    estimate.sd[bin] = kSurfaceScale * std::sqrt(std::max(second - first * first, 0.0));
}

void quantilesOf(const GaussianMixture& distribution, std::size_t bin, TerrainEstimate& estimate)
{
    const double ceiling = estimate.ceiling[bin];
    const auto height = [&](double p) {  // y falls as a covered bin's height rises
        return toHeight(
            distribution.quantile(static_cast<int>(bin), std::isinf(ceiling) ? p : 1.0 - p),
            ceiling);
    };
    estimate.q10[bin] = height(0.1);
    estimate.height[bin] = height(0.5);
    estimate.q90[bin] = height(0.9);
}

int drawsOf(const Settings& settings)
{
    return settings.stopEarly ? std::min(settings.draws, kEnoughDraws) : settings.draws;
}

std::vector<Heights> heightDraws(const GaussianMixture& distribution,
                                 const TerrainEstimate& estimate, const Poll& poll)
{
    std::mt19937_64 rng(estimate.settings.seed);
    const int count = drawsOf(estimate.settings);
    std::vector<Heights> draws;
    draws.reserve(static_cast<std::size_t>(count));
    const auto keep = [&](const Eigen::VectorXd& y) {
        Heights& draw = draws.emplace_back();
        for (std::size_t i = 0; i < kBins; ++i)
            draw[i] = toHeight(y[static_cast<Eigen::Index>(i)], estimate.ceiling[i]);
    };
    distribution.draw(count, rng, keep, poll);
    return draws;
}

}  // namespace

GaussianMixture surfaceDistribution(const ClearanceModel& model, const Eigen::VectorXd& features,
                                    unsigned covered, Method method)
{
    if (!isClosedForm(method))
        throw std::invalid_argument(fmt::format("method {} has no closed form", name(method)));
    const Heights centre = model.predict(features, covered);
    const Eigen::Map<const Eigen::VectorXd> mean(centre.data(), kBins);
    if (method == Method::Joint)
        return {Eigen::VectorXd::Ones(1), mean, model.residualCovariance(covered)};

    const ResidualSample sample = model.localResiduals(features, covered);
    const Eigen::VectorXd middle = sample.residual * sample.weight;
    const Eigen::MatrixXd spread = sample.residual.colwise() - middle;
    GaussianMixture mixture;
    mixture.weight = sample.weight;
    mixture.mean = (std::sqrt(1.0 - kSmoothing * kSmoothing) * spread).colwise() + (mean + middle);
    mixture.covariance =
        kSmoothing * kSmoothing * spread * sample.weight.asDiagonal() * spread.transpose();
    return mixture;
}

TerrainEstimate reconstructClosedForm(const Proprioception& s, std::span<const ArmReading> arm,
                                      const RobotModel& robot, const ClearanceModel& model,
                                      const Settings& settings, const Poll& poll)
{
    check(settings);
    callPoll(poll);
    TerrainEstimate estimate;
    estimate.settings = settings;
    estimate.ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);
    const Eigen::VectorXd x = featuresFor(model, s);
    estimate.novelty = model.novelty(x);
    GaussianMixture distribution =
        surfaceDistribution(model, x, coveredBins(estimate.ceiling), settings.method);

    MeasuredBins measured = measureBins(robot, s, arm, estimate.ceiling, settings);
    applyMeasurements(distribution, measured, model, estimate);
    if (estimate.novelty > 1.0)
        estimate.warnings.emplace_back(
            TR_NOOP("core",
                    "unlike the training scenes: %1 times the distance that 1 % of them exceed"),
            fixed(estimate.novelty, 1));

    for (std::size_t i = 0; i < kBins; ++i) {
        momentsOf(distribution, i, estimate);
        quantilesOf(distribution, i, estimate);
        estimate.rhat[i] = 1.0;
        estimate.ess[i] = drawsOf(settings);
    }
    estimate.draws = heightDraws(distribution, estimate, poll);
    writeTouch(estimate, pressedBins(robot, s, estimate.ceiling));
    addHazards(estimate, settings.hazardRate, poll);
    return finite(std::move(estimate), poll);
}

}  // namespace terratact
