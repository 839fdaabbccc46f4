#include "core/infer/closed_form.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/learn/clearance.h"
#include "core/learn/hyperparameters.h"
#include "core/terrain/body_ceiling.h"
#include "core/terrain/kinematic_reconstruction.h"

namespace terratact {

namespace {

constexpr double kContradiction = 3.0;  // [sd] beyond which two statements exclude each other

/// A height that something has touched.
struct Touch {
    int bin = 0;
    double height = 0.0, sd = 0.0;  ///< [m]
    Origin origin = Origin::Contact;
};

void check(const Settings& settings)
{
    if (!isClosedForm(settings.method))
        throw std::invalid_argument(
            fmt::format("method {} has no closed form", name(settings.method)));
    if (settings.draws < 1) throw std::invalid_argument("an estimate needs at least one draw");
    if (!(settings.armSd > 0.0) || !(settings.forceThreshold >= 0.0))
        throw std::invalid_argument("arm sd must be positive and the force threshold 0 or more");
}

std::vector<Touch> contacts(const Proprioception& s, const RobotModel& robot,
                            const ClearanceModel& model, TerrainEstimate& estimate)
{
    const Settings& settings = estimate.settings;
    if (settings.contacts == ContactRule::None) return {};
    KinematicReconstruction found = reconstructContacts(robot, s, settings.forceThreshold,
                                                        settings.contacts == ContactRule::Isolated);
    estimate.warnings = std::move(found.warnings);
    std::vector<Touch> touches;
    for (int bin = 0; bin < kBins; ++bin)
        if (const auto& height = found.height[static_cast<std::size_t>(bin)])
            touches.push_back(
                {bin, *height + model.contactBias(), model.contactSd(), Origin::Contact});
    return touches;
}

std::vector<Touch> probes(std::span<const ArmReading> arm)
{
    std::vector<Touch> touches;
    for (const ArmReading& reading : arm) {
        if (reading.bin < 0 || reading.bin >= kBins || !std::isfinite(reading.height)
            || !(reading.sd > 0.0))
            throw std::invalid_argument(
                "an arm reading needs a bin 0 to 10, a finite height and a positive sd");
        touches.push_back({reading.bin, reading.height, reading.sd, Origin::Arm});
    }
    return touches;
}

std::string_view words(Origin origin)
{
    return origin == Origin::Arm ? "the arm" : "a contact";
}

/// Conditions the distribution, flags what cannot be.
void take(GaussianMixture& distribution, const Touch& touch, TerrainEstimate& estimate)
{
    const auto bin = static_cast<std::size_t>(touch.bin);
    const double ceiling = estimate.ceiling[bin];
    if (touch.height > ceiling + kContradiction * touch.sd)
        estimate.warnings.push_back(fmt::format(
            "{} found bin {:+.1f} m {:.0f} mm above the robot's own lower edge",
            words(touch.origin), binCentre(touch.bin), 1000.0 * (touch.height - ceiling)));
    const double y = toSurface(touch.height, ceiling);
    const double error =
        std::isinf(ceiling)
            ? touch.sd
            : std::log1p(touch.sd / (std::max(ceiling - touch.height, 0.0) + kClearanceOffset));
    distribution.condition(touch.bin, y, error);
    estimate.origin[bin] = touch.origin;
}

void flagDisagreement(const std::vector<Touch>& touches, TerrainEstimate& estimate)
{
    for (const Touch& a : touches)
        for (const Touch& b : touches)
            if (a.origin == Origin::Contact && b.origin == Origin::Arm && a.bin == b.bin
                && std::abs(a.height - b.height) > kContradiction * std::hypot(a.sd, b.sd))
                estimate.warnings.push_back(
                    fmt::format("contact and arm disagree about bin {:+.1f} m by {:.0f} mm",
                                binCentre(a.bin), 1000.0 * std::abs(a.height - b.height)));
}

/// Mean and sd of a bin's height: y is a mixture of Gaussians, so exp(y) one of log-normals.
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
    const double first = (weight * (mean + 0.5 * variance).exp()).sum();
    const double second = (weight * (2.0 * mean + 2.0 * variance).exp()).sum();
    estimate.mean[bin] = estimate.ceiling[bin] - std::max(first - kClearanceOffset, 0.0);
    estimate.sd[bin] = std::sqrt(std::max(second - first * first, 0.0));
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

std::vector<Heights> heightDraws(const GaussianMixture& distribution,
                                 const TerrainEstimate& estimate)
{
    std::mt19937_64 rng(estimate.settings.seed);
    const Eigen::MatrixXd y = distribution.draw(estimate.settings.draws, rng);
    std::vector<Heights> draws(static_cast<std::size_t>(y.cols()));
    for (Eigen::Index d = 0; d < y.cols(); ++d)
        for (std::size_t i = 0; i < kBins; ++i)
            draws[static_cast<std::size_t>(d)][i] =
                toHeight(y(static_cast<Eigen::Index>(i), d), estimate.ceiling[i]);
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
                                      const Settings& settings)
{
    check(settings);
    TerrainEstimate estimate;
    estimate.settings = settings;
    estimate.ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);
    const Eigen::VectorXd x = features(FeatureSet::Paf, s);
    estimate.novelty = model.novelty(x);
    GaussianMixture distribution =
        surfaceDistribution(model, x, coveredBins(estimate.ceiling), settings.method);

    std::vector<Touch> touches = contacts(s, robot, model, estimate);
    const std::vector<Touch> probed = probes(arm);
    touches.insert(touches.end(), probed.begin(), probed.end());
    for (const Touch& touch : touches) take(distribution, touch, estimate);
    flagDisagreement(touches, estimate);
    if (estimate.novelty > 1.0)
        estimate.warnings.push_back(fmt::format(
            "unlike the training scenes: {:.1f} times the distance that 1 % of them exceed",
            estimate.novelty));

    for (std::size_t i = 0; i < kBins; ++i) {
        momentsOf(distribution, i, estimate);
        quantilesOf(distribution, i, estimate);
        estimate.rhat[i] = 1.0;
        estimate.ess[i] = settings.draws;
    }
    estimate.draws = heightDraws(distribution, estimate);
    return estimate;
}

}  // namespace terratact
