#include "core/infer/reconstruct_clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/clearance_states.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {

namespace {

void checkClearance(const Settings& settings)
{
    if (settings.method != Method::Clearance)
        throw std::invalid_argument(
            fmt::format("method {} does not sample clearances", name(settings.method)));
    checkSettings(settings);
}

ClearanceStates::Measured states(const MeasuredBins& measured, const Heights& ceiling)
{
    ClearanceStates::Measured result;
    for (std::size_t i = 0; i < kBins; ++i)
        if (measured.bin[i])
            result[i] = measuredState(measured.bin[i]->height, measured.bin[i]->sd, ceiling[i]);
    return result;
}

/// Makes exact measurements known states of the problem. Returns their heights, none above its
/// ceiling.
OptionalHeights fixExact(const MeasuredBins& measured, const ClearanceStates::Measured& states,
                         GibbsProblem& problem, TerrainEstimate& estimate)
{
    OptionalHeights known;
    for (std::size_t i = 0; i < kBins; ++i) {
        if (!measured.bin[i] || measured.bin[i]->sd > kExactSd) continue;
        problem.known[i] = states[i]->mean;
        MeasuredHeight fixed = *measured.bin[i];
        fixed.height = std::min(fixed.height, estimate.ceiling[i]);
        known[i] = fixed.height;
        fixBin(estimate, static_cast<int>(i), fixed);
        estimate.q90[i] = std::min(estimate.q90[i], estimate.ceiling[i]);
    }
    return known;
}

}  // namespace

SceneSampling clearanceSampling(const Proprioception& s, std::span<const ArmReading> arm,
                                const RobotModel& robot, const ClearanceConditionals& models,
                                const Settings& settings, const Watch& watch)
{
    checkClearance(settings);
    SceneSampling sampling;
    TerrainEstimate& estimate = sampling.estimate;
    estimate.settings = settings;
    estimate.ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);
    const Eigen::VectorXd x = features(FeatureSet::Paf, s);
    MeasuredBins measured = measureBins(robot, s, arm, estimate.ceiling, settings);
    estimate.warnings = std::move(measured.warnings);
    for (std::size_t i = 0; i < kBins; ++i)
        if (measured.bin[i]) estimate.origin[i] = measured.bin[i]->origin;

    GibbsProblem& problem = sampling.problem;
    problem = problemFor(settings);
    problem.ceiling.fill(std::numeric_limits<double>::infinity());
    problem.rule = CeilingRule::None;  // the states stay below the ceiling by construction
    const ClearanceStates::Measured measuredStates = states(measured, estimate.ceiling);
    sampling.known = fixExact(measured, measuredStates, problem, estimate);
    sampling.centre = Centre::Median;
    sampling.pressed = pressedBins(robot, s, estimate.ceiling);
    sampling.conditionals =
        std::make_unique<ClearanceStates>(models, estimate.ceiling, x, measuredStates,
                                          settings.precision, settings.inducing, pollOf(watch));
    sampling.process = [&models, settings,
                        ceiling = estimate.ceiling](int bin) -> const GaussianProcess& {
        return models.gp(bin, regimeOf(ceiling[static_cast<std::size_t>(bin)]), settings.inducing);
    };
    return sampling;
}

}  // namespace terratact
