#include "core/infer/reconstruct.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/bin_conditionals.h"
#include "core/robot/side_plane.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {

namespace {

void check(const Settings& settings, const BinModels& models)
{
    if (!isOfPaper(settings.method))
        throw std::invalid_argument(
            fmt::format("method {} is not one of the paper's", name(settings.method)));
    if (models.set() == FeatureSet::Paf && !usesForces(settings.method))
        throw std::invalid_argument(fmt::format("method {} needs the {} models, not the {} ones",
                                                name(settings.method), name(FeatureSet::Pa),
                                                name(models.set())));
    checkSettings(settings);
}

}  // namespace

SceneSampling paperSampling(const Proprioception& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const BinModels& models,
                            const Settings& settings, const Watch& watch)
{
    check(settings, models);
    SceneSampling sampling;
    TerrainEstimate& estimate = sampling.estimate;
    estimate.settings = settings;
    estimate.ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);

    GibbsProblem& problem = sampling.problem;
    problem = problemFor(settings);
    problem.s = features(models.set(), s);
    problem.ceiling = estimate.ceiling;
    problem.rule = usesCeiling(settings.method) ? settings.ceiling : CeilingRule::None;
    MeasuredBins measured = measureBins(robot, s, arm, estimate.ceiling, settings);
    estimate.warnings = std::move(measured.warnings);
    for (std::size_t i = 0; i < kBins; ++i) {
        if (!measured.bin[i]) continue;
        problem.known[i] = measured.bin[i]->height;
        fixBin(estimate, static_cast<int>(i), *measured.bin[i]);
    }
    sampling.known = problem.known;
    sampling.centre = Centre::Mean;
    sampling.pressed = pressedBins(robot, s, estimate.ceiling);
    sampling.conditionals = std::make_unique<BinConditionals>(models, problem.s, problem.precision,
                                                              problem.inducing, pollOf(watch));
    sampling.process = [&models, settings](int bin) -> const GaussianProcess& {
        return models.bin(bin, settings.inducing);
    };
    return sampling;
}

void warnIfNotPlanar(TerrainEstimate& estimate, const Measurement& m)
{
    const Settings& settings = estimate.settings;
    if (std::abs(m.roll) > settings.rollLimit)
        estimate.warnings.emplace_back(
            TR_NOOP("core", "roll %1°: the ground is not the same left and right"),
            fixed(m.roll * 57.29577951, 1));
    if (flipperAsymmetry(m) > settings.asymmetryLimit)
        estimate.warnings.emplace_back(
            TR_NOOP("core",
                    "left and right flippers differ by %1°: the ground is not the same left "
                    "and right"),
            fixed(flipperAsymmetry(m) * 57.29577951, 1));
    if (hasTurned(m.differential))
        estimate.warnings.emplace_back(TR_NOOP(
            "core", "the track differential has turned: left and right are estimated as one "
                    "plane"));
}

}  // namespace terratact
