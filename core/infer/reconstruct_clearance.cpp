#include "core/infer/reconstruct_clearance.h"

#include <fmt/format.h>

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

/// Draws of y become draws of heights.
void toHeights(GibbsDraws& draws, const Heights& ceiling)
{
    for (std::size_t k = 0; k < draws.bins.size(); ++k) {
        const double above = ceiling[static_cast<std::size_t>(draws.bins[k])];
        for (double& value : draws.draws[k].reshaped()) value = fromLogClearance(value, above);
    }
}

}  // namespace

TerrainEstimate reconstructClearance(const Proprioception& s, std::span<const ArmReading> arm,
                                     const RobotModel& robot, const ClearanceConditionals& models,
                                     const Settings& settings, const Watch& watch)
{
    check(settings);
    TerrainEstimate estimate;
    estimate.settings = settings;
    estimate.ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);
    const Eigen::VectorXd x = features(FeatureSet::Paf, s);
    MeasuredBins measured = measureBins(robot, s, arm, estimate.ceiling, settings);
    estimate.warnings = std::move(measured.warnings);

    GibbsProblem problem = problemFor(settings);
    problem.ceiling.fill(std::numeric_limits<double>::infinity());
    problem.rule = CeilingRule::None;  // the states keep below the ceiling by themselves
    const ClearanceStates conditionals(models, estimate.ceiling, x,
                                       states(measured, estimate.ceiling), settings.precision,
                                       settings.inducing, [&watch] { stopIfCancelled(watch); });
    GibbsDraws draws = sampleStates(conditionals, problem, watch);
    toHeights(draws, estimate.ceiling);
    for (std::size_t i = 0; i < kBins; ++i) {
        stopIfCancelled(watch);
        summariseDraws(estimate, draws.bins[i], draws.draws[i],
                       measured.bin[i] ? measured.bin[i]->origin : Origin::Sampled, Centre::Median);
        warnIfMended(estimate, draws.bins[i],
                     models.gp(draws.bins[i], regimeOf(estimate.ceiling[i]), settings.inducing));
    }
    estimate.draws = jointDraws(draws, {});
    judgeConvergence(estimate, draws.bins);
    return estimate;
}

}  // namespace terratact
