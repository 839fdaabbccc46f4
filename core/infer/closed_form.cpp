#include "core/infer/closed_form.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "core/infer/closed_form_parts.h"
#include "core/infer/estimate/hazards.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/draw_summary.h"
#include "core/learn/kernels/hyperparameters.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {

namespace {

/// Returns the features of s in the order that the model's processes expect.
Eigen::VectorXd featuresFor(const ClearanceModel& model, const Proprioception& s)
{
    const bool enough = (absentFeatures(missingFeatures(s)) & ~model.without()).none();
    return enough ? knownFeatures(s) : features(FeatureSet::Paf, s);
}

std::vector<Heights> heightDraws(const GaussianMixture& distribution,
                                 const TerrainEstimate& estimate, const Poll& poll)
{
    std::mt19937_64 rng(estimate.settings.seed);
    const int count = drawsOf(estimate.settings);
    std::vector<Heights> draws;
    draws.reserve(static_cast<std::size_t>(count));
    const auto keep = [&](const Eigen::VectorXd& y) {
        draws.push_back(heightsOf(y, 0, estimate.ceiling));
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

    return smoothed(mean, model.localResiduals(features, covered));
}

unsigned coveredAt(const RobotModel& robot, const Proprioception& s)
{
    return coveredBins(bodyCeiling(robot, s.pitch, s.front, s.rear));
}

TerrainEstimate estimateFrom(SurfacePrediction prediction, const Proprioception& s,
                             std::span<const ArmReading> arm, const RobotModel& robot,
                             const Settings& settings, const Poll& poll)
{
    TerrainEstimate estimate;
    estimate.settings = settings;
    estimate.ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);
    estimate.novelty = prediction.novelty;
    GaussianMixture& distribution = prediction.distribution;
    MeasuredBins measured = measureBins(robot, s, arm, estimate.ceiling, settings);
    addEarlierArm(measured, prediction.earlier, prediction.contact.has_value());
    const auto hazards =
        applyMeasurements(distribution, 0, std::move(measured), prediction.contact, estimate);
    warnIfNovel(estimate);
    writeBins(distribution, 0, estimate);
    estimate.draws = heightDraws(distribution, estimate, poll);
    writeTouch(estimate, pressedBins(robot, s, estimate.ceiling));
    writeRemembered(estimate, prediction.earlier, robot, s);
    addMeasuredHazards(estimate, hazards, poll);
    addHazards(estimate, settings.hazardRate, poll);
    return finite(std::move(estimate), poll);
}

TerrainEstimate reconstructClosedForm(const Proprioception& s, std::span<const ArmReading> arm,
                                      const RobotModel& robot, const ClearanceModel& model,
                                      const Settings& settings, const Poll& poll,
                                      const EarlierTouch& earlier)
{
    requireClosedForm(settings);
    callPoll(poll);
    const Eigen::VectorXd x = featuresFor(model, s);
    return estimateFrom({surfaceDistribution(model, x, coveredAt(robot, s), settings.method),
                         contactErrorOf(model), model.novelty(x), earlier},
                        s, arm, robot, settings, poll);
}

}  // namespace terratact
