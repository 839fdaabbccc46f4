#include "core/infer/closed_form_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/learn/model/clearance.h"

namespace terratact {

namespace {

/// Distance in standard deviations beyond which a measurement contradicts all similar training
/// scenes. Only their spread counts then.
constexpr double kSurprised = 2.0;

/// A measured height as a surface coordinate.
struct SurfaceReading {
    double y = 0.0, error = 0.0;
};

/// A height above the deepest sinking of the robot counts as the deepest sinking.
SurfaceReading surfaceReading(const MeasuredHeight& measured, double ceiling)
{
    const double height = std::min(measured.height, ceiling + kDeepestSinking);
    const double y = toSurface(height, ceiling);
    return {y, std::abs(toSurface(height - measured.sd, ceiling) - y)};
}

/// Returns the hazard that a reading of the arm indicates, by hazardProbability().
MeasuredHazard hazardBy(const GaussianMixture& distribution, int i, std::size_t bin,
                        const MeasuredHeight& measured, double ceiling, double rate)
{
    const SurfaceReading reading = surfaceReading(measured, ceiling);
    const bool isCovered = std::isfinite(ceiling);
    const double median = distribution.quantile(i, 0.5);
    const double expected = toHeight(median, ceiling);
    // |dy/dh| of the surface coordinate
    const double slope =
        isCovered ? 1.0 / std::hypot(kSurfaceScale, ceiling - measured.height) : 1.0;
    MeasuredHazard hazard{static_cast<int>(bin), measured.height, measured.sd,
                          measured.height - expected, 0.0};
    hazard.probability = hazardProbability(
        hazard.offset, measured.sd,
        distribution.logDensity(i, reading.y, reading.error) + std::log(slope), isCovered, rate);
    return hazard;
}

/// A hazard more probable than this explains a reading, which then does not affect the other bins.
constexpr double kSurelyHazard = 0.95;

/// Conditions the distribution of one bin's surface coordinate.
void applyMeasurement(GaussianMixture& distribution, int i, const MeasuredHeight& measured,
                      double ceiling)
{
    const auto [y, error] = surfaceReading(measured, ceiling);
    if (distribution.surprise(i, y, error) > kSurprised) distribution = distribution.collapsed();
    distribution.condition(i, y, error);
}

/// Writes mean and sd of a bin's height; y is a mixture of Gaussians.
void momentsOf(const GaussianMixture& distribution, int i, std::size_t bin,
               TerrainEstimate& estimate)
{
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
    // An infinite depth stays: it is a wrong model's, and the estimate is refused.
    const double depth = kSurfaceScale * first;
    estimate.mean[bin] =
        estimate.ceiling[bin]
        - (std::isfinite(depth) ? std::clamp(depth, -kDeepestSinking, kDeepestSurface) : depth);
    const double sd = kSurfaceScale * std::sqrt(std::max(second - first * first, 0.0));
    estimate.sd[bin] = sd < kDeepestSurface ? sd : kDeepestSurface;  // also of an overflow
}

void quantilesOf(const GaussianMixture& distribution, int i, std::size_t bin,
                 TerrainEstimate& estimate)
{
    const double ceiling = estimate.ceiling[bin];
    const auto height = [&](double p) {  // y falls as a covered bin's height rises
        return toHeight(distribution.quantile(i, std::isinf(ceiling) ? p : 1.0 - p), ceiling);
    };
    estimate.q10[bin] = height(0.1);
    estimate.height[bin] = height(0.5);
    estimate.q90[bin] = height(0.9);
}

}  // namespace

void requireClosedForm(const Settings& settings)
{
    if (!isClosedForm(settings.method))
        throw std::invalid_argument(
            fmt::format("method {} has no closed form", name(settings.method)));
    if (settings.draws < 1 || settings.draws > kMaxDraws)
        throw std::invalid_argument(fmt::format("an estimate needs 1 to {} draws", kMaxDraws));
    if (!(settings.forceThreshold >= 0.0))
        throw std::invalid_argument("the force threshold must be 0 or more");
}

GaussianMixture smoothed(const Eigen::VectorXd& mean, const ResidualSample& sample)
{
    const Eigen::VectorXd middle = sample.residual * sample.weight;
    const Eigen::MatrixXd spread = sample.residual.colwise() - middle;
    GaussianMixture mixture;
    mixture.weight = sample.weight;
    mixture.mean = (std::sqrt(1.0 - kSmoothing * kSmoothing) * spread).colwise() + (mean + middle);
    mixture.covariance =
        kSmoothing * kSmoothing * spread * sample.weight.asDiagonal() * spread.transpose();
    return mixture;
}

void addEarlierArm(MeasuredBins& measured, const EarlierTouch& earlier, bool usesContacts)
{
    for (std::size_t i = 0; i < kBins; ++i) {
        const auto& now = measured.bin[i];
        const bool isNow = now && (usesContacts || now->origin == Origin::Arm);
        if (earlier.arm[i] && !isNow) measured.bin[i] = earlier.arm[i];
    }
}

void writeRemembered(TerrainEstimate& estimate, const EarlierTouch& earlier,
                     const RobotModel& robot, const Proprioception& s)
{
    const bool any = std::ranges::any_of(earlier.felt, [](auto cells) { return cells != 0; });
    if (any) addRemembered(estimate, earlier.felt, cellsOf(pressedStretches(robot, s)));
}

std::vector<MeasuredHazard> applyMeasurements(GaussianMixture& distribution, int first,
                                              MeasuredBins measured,
                                              const std::optional<ContactError>& contact,
                                              TerrainEstimate& estimate)
{
    std::vector<MeasuredHazard> hazards;
    hazards.reserve(kBins);
    for (std::size_t i = 0; i < kBins; ++i) {
        if (!measured.bin[i]) continue;
        MeasuredHeight& height = *measured.bin[i];
        estimate.origin[i] = height.origin;
        if (height.origin == Origin::Contact) {
            if (!contact) continue;
            height = {height.height + contact->bias, contact->sd, Origin::Contact};
        }
        const int coordinate = first + static_cast<int>(i);
        if (height.origin != Origin::Contact && i >= std::size_t{kFirstAhead}) {
            hazards.push_back(hazardBy(distribution, coordinate, i, height, estimate.ceiling[i],
                                       estimate.settings.hazardRate));
            if (hazards.back().probability > kSurelyHazard) continue;
        }
        applyMeasurement(distribution, coordinate, height, estimate.ceiling[i]);
    }
    estimate.warnings = std::move(measured.warnings);
    return hazards;
}

void warnIfNovel(TerrainEstimate& estimate)
{
    if (estimate.novelty > 1.0)
        estimate.warnings.emplace_back(
            TR_NOOP("core",
                    "unlike the training scenes: %1 times the distance that 1 % of them exceed"),
            fixed(estimate.novelty, 1));
}

int drawsOf(const Settings& settings)
{
    return settings.stopEarly ? std::min(settings.draws, kEnoughDraws) : settings.draws;
}

void writeBins(const GaussianMixture& distribution, int first, TerrainEstimate& estimate)
{
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        const int i = first + static_cast<int>(bin);
        momentsOf(distribution, i, bin, estimate);
        quantilesOf(distribution, i, bin, estimate);
        estimate.rhat[bin] = 1.0;
        estimate.ess[bin] = drawsOf(estimate.settings);
    }
}

Heights heightsOf(const Eigen::VectorXd& y, int first, const Heights& ceiling)
{
    Heights draw{};
    for (std::size_t i = 0; i < kBins; ++i)
        draw[i] = toHeight(y[first + static_cast<Eigen::Index>(i)], ceiling[i]);
    return draw;
}

}  // namespace terratact
