#include "core/infer/reconstruct.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/infer/convergence.h"
#include "core/infer/gibbs.h"
#include "core/infer/quantile.h"
#include "core/terrain/body_ceiling.h"
#include "core/terrain/kinematic_reconstruction.h"

namespace terratact {

namespace {

constexpr double kNormalQ90 = 1.2815515655446004;  // Φ⁻¹(0.9)
constexpr double kCeilingContradiction =
    3.0;  // [sd] a reading this far above the ceiling cannot be

void check(const Settings& settings, const BinModels& models)
{
    if (std::find(kPaperMethods.begin(), kPaperMethods.end(), settings.method)
        == kPaperMethods.end())
        throw std::invalid_argument(
            fmt::format("method {} is not one of the paper's", name(settings.method)));
    const FeatureSet wanted = usesForces(settings.method) ? FeatureSet::Paf : FeatureSet::Pa;
    if (models.set() != wanted)
        throw std::invalid_argument(fmt::format("method {} needs the {} models, not the {} ones",
                                                name(settings.method), name(wanted),
                                                name(models.set())));
    if (settings.draws < 1 || settings.chains < 1 || settings.burnIn < 0)
        throw std::invalid_argument(
            "an estimate needs at least one draw, one chain and no negative burn-in");
    if (!(settings.contactSd > 0.0) || !(settings.armSd > 0.0) || !(settings.forceThreshold >= 0.0))
        throw std::invalid_argument(
            "contact and arm sd must be positive and the force threshold 0 or more");
}

void fix(TerrainEstimate& estimate, std::size_t bin, double height, double sd, Origin origin)
{
    estimate.mean[bin] = height;
    estimate.height[bin] = height;
    estimate.sd[bin] = sd;
    estimate.q10[bin] = height - kNormalQ90 * sd;
    estimate.q90[bin] = height + kNormalQ90 * sd;
    estimate.origin[bin] = origin;
    estimate.rhat[bin] = 1.0;
    estimate.ess[bin] = estimate.settings.draws;
}

OptionalHeights fixContacts(TerrainEstimate& estimate, const RobotModel& robot,
                            const Proprioception& s)
{
    const Settings& settings = estimate.settings;
    if (!usesForces(settings.method)) return {};
    KinematicReconstruction contacts = reconstructContacts(
        robot, s, settings.forceThreshold, settings.contacts == ContactRule::Isolated);
    for (std::size_t i = 0; i < kBins; ++i)
        if (contacts.height[i])
            fix(estimate, i, *contacts.height[i], settings.contactSd, Origin::Contact);
    estimate.warnings = std::move(contacts.warnings);
    return contacts.height;
}

void fixArm(TerrainEstimate& estimate, std::span<const ArmReading> arm, OptionalHeights& known)
{
    for (const ArmReading& reading : arm) {
        if (reading.bin < 0 || reading.bin >= kBins || !std::isfinite(reading.height)
            || !(reading.sd > 0.0))
            throw std::invalid_argument(
                "an arm reading needs a bin 0 to 10, a finite height and a positive sd");
        const auto bin = static_cast<std::size_t>(reading.bin);
        known[bin] = reading.height;
        fix(estimate, bin, reading.height, reading.sd, Origin::Arm);
        if (reading.height > estimate.ceiling[bin] + kCeilingContradiction * reading.sd)
            estimate.warnings.push_back(fmt::format(
                "the arm found bin {:+.1f} m {:.0f} mm above the robot's own lower edge",
                binCentre(reading.bin), 1000.0 * (reading.height - estimate.ceiling[bin])));
    }
}

void summarise(TerrainEstimate& estimate, std::size_t bin, const Eigen::MatrixXd& draws)
{
    const double mean = draws.mean();
    estimate.mean[bin] = mean;
    estimate.height[bin] = mean;
    estimate.sd[bin] = std::sqrt((draws.array() - mean).square().mean());
    const std::vector<double> all(draws.data(), draws.data() + draws.size());
    estimate.q10[bin] = quantile(all, 0.1);
    estimate.q90[bin] = quantile(all, 0.9);
    estimate.origin[bin] = Origin::Sampled;
    estimate.rhat[bin] = rankNormalisedRhat(draws);
    estimate.ess[bin] = bulkEss(draws);
}

/// The chains' draws one after the other; known bins stand still at their heights.
std::vector<Heights> jointDraws(const GibbsDraws& draws, const OptionalHeights& known)
{
    Heights start{};
    for (std::size_t i = 0; i < kBins; ++i) start[i] = known[i].value_or(0.0);
    const Eigen::Index count = draws.draws.empty() ? 1 : draws.draws.front().size();
    std::vector<Heights> all(static_cast<std::size_t>(count), start);
    for (std::size_t k = 0; k < draws.bins.size(); ++k)
        for (Eigen::Index d = 0; d < count; ++d)
            all[static_cast<std::size_t>(d)][static_cast<std::size_t>(draws.bins[k])] =
                draws.draws[k].data()[d];
    return all;
}

void judgeConvergence(TerrainEstimate& estimate)
{
    double worstRhat = 1.0;
    double worstEss = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < kBins; ++i) {
        if (estimate.origin[i] != Origin::Sampled) continue;
        worstRhat = std::max(worstRhat, estimate.rhat[i]);
        worstEss = std::min(worstEss, estimate.ess[i]);
    }
    estimate.converged = worstRhat <= kRhatLimit && worstEss >= kEssLimit;
    if (!estimate.converged)
        estimate.warnings.push_back(fmt::format(
            "chains not converged: R-hat {:.3f} (limit {}), effective draws {:.0f} (limit {:.0f})",
            worstRhat, kRhatLimit, worstEss, kEssLimit));
}

}  // namespace

TerrainEstimate reconstruct(const Proprioception& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const BinModels& models,
                            const Settings& settings, const Watch& watch)
{
    check(settings, models);
    TerrainEstimate estimate;
    estimate.settings = settings;
    estimate.ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);

    GibbsProblem problem;
    problem.s = features(models.set(), s);
    problem.known = fixContacts(estimate, robot, s);
    fixArm(estimate, arm, problem.known);
    problem.ceiling = estimate.ceiling;
    problem.rule = usesCeiling(settings.method) ? settings.ceiling : CeilingRule::None;
    problem.scan = settings.scan;
    problem.chains = settings.chains;
    problem.burnIn = settings.burnIn;
    problem.keptPerChain = (settings.draws + settings.chains - 1) / settings.chains;
    problem.seed = settings.seed;

    const GibbsDraws draws = sampleHeights(models, problem, watch);
    for (std::size_t k = 0; k < draws.bins.size(); ++k)
        summarise(estimate, static_cast<std::size_t>(draws.bins[k]), draws.draws[k]);
    estimate.draws = jointDraws(draws, problem.known);
    judgeConvergence(estimate);
    return estimate;
}

void warnIfNotPlanar(TerrainEstimate& estimate, const Measurement& m)
{
    const Settings& settings = estimate.settings;
    if (std::abs(m.roll) > settings.rollLimit)
        estimate.warnings.push_back(fmt::format(
            "roll {:.1f}°: the ground is not the same left and right", m.roll * 57.29577951));
    const double front = std::abs(m.frontLeft - m.frontRight);
    const double rear = std::abs(m.rearLeft - m.rearRight);
    if (std::max(front, rear) > settings.asymmetryLimit)
        estimate.warnings.push_back(fmt::format(
            "left and right flippers differ by {:.1f}°: the ground is not the same left and right",
            std::max(front, rear) * 57.29577951));
}

}  // namespace terratact
