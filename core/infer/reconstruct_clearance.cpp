#include "core/infer/reconstruct_clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/infer/clearance_states.h"
#include "core/infer/draw_summary.h"
#include "core/infer/gibbs.h"
#include "core/infer/measured_bins.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {

namespace {

void check(const Settings& settings)
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

/// Exact measurements become known states of the problem.  Their heights, none above its ceiling.
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

TerrainEstimate reconstructClearance(const Proprioception& s, std::span<const ArmReading> arm,
                                     const RobotModel& robot, const ClearanceConditionals& models,
                                     const Settings& settings, const Watch& watch,
                                     const WeakHeights& weak)
{
    check(settings);
    TerrainEstimate estimate;
    estimate.settings = settings;
    estimate.ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);
    const Eigen::VectorXd x = features(FeatureSet::Paf, s);
    MeasuredBins measured = measureBins(robot, s, arm, estimate.ceiling, settings, weak);
    estimate.warnings = std::move(measured.warnings);

    GibbsProblem problem = problemFor(settings);
    problem.ceiling.fill(std::numeric_limits<double>::infinity());
    problem.rule = CeilingRule::None;  // the states keep below the ceiling by themselves
    const ClearanceStates::Measured measuredStates = states(measured, estimate.ceiling);
    const OptionalHeights known = fixExact(measured, measuredStates, problem, estimate);
    const ClearanceStates conditionals(models, estimate.ceiling, x, measuredStates,
                                       settings.precision, settings.inducing,
                                       [&watch] { stopIfCancelled(watch); });
    const GibbsDraws draws = sampleStates(conditionals, problem, watch);
    for (std::size_t k = 0; k < draws.bins.size(); ++k) {
        stopIfCancelled(watch);
        const auto i = static_cast<std::size_t>(draws.bins[k]);
        summariseDraws(estimate, draws.bins[k], draws.draws[k],
                       measured.bin[i] ? measured.bin[i]->origin : Origin::Sampled, Centre::Median);
        warnIfMended(estimate, draws.bins[k],
                     models.gp(draws.bins[k], regimeOf(estimate.ceiling[i]), settings.inducing));
    }
    conclude(estimate, draws, known);
    return finite(std::move(estimate));
}

}  // namespace terratact
