#include "core/infer/two_track_form.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "core/infer/closed_form_parts.h"
#include "core/infer/estimate/hazards.h"
#include "core/infer/sampling/draw_summary.h"
#include "core/learn/data/side_features.h"
#include "core/robot/side_plane.h"
#include "core/terrain/body_ceiling.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

namespace {

constexpr std::array kSides{Side::Left, Side::Right};

constexpr std::size_t numberOf(Side side)
{
    return side == Side::Left ? 0 : 1;
}

constexpr int firstOf(Side side)
{
    return side == Side::Left ? 0 : kBins;
}

const ClearanceModel& modelOf(const SideModels& models, Side side)
{
    return side == Side::Left ? models.left : models.right;
}

/// Checks that the models need no feature that s lacks.
void requireFeatures(const TwoTrackReadings& s, const SideModels& models)
{
    for (const Side side : kSides)
        if ((absentFeatures(s, side) & ~modelOf(models, side).without()).any())
            throw std::invalid_argument("a feature of a side is unknown that its model needs");
}

void drawBoth(TwoTrackEstimate& estimate, const GaussianMixture& distribution,
              const Settings& settings, const Poll& poll)
{
    std::mt19937_64 rng(settings.seed);
    const int count = drawsOf(settings);
    for (TerrainEstimate& side : estimate.side) side.draws.reserve(static_cast<std::size_t>(count));
    distribution.draw(
        count, rng,
        [&](const Eigen::VectorXd& y) {
            for (const Side side : kSides) {
                TerrainEstimate& own = estimate.side[numberOf(side)];
                own.draws.push_back(heightsOf(y, firstOf(side), own.ceiling));
            }
        },
        poll);
}

/// Adds hazards; those of both sides are independent.
void addOwnHazards(TerrainEstimate& estimate, Side side, std::span<const MeasuredHazard> measured,
                   const Poll& poll)
{
    const std::uint64_t seed = estimate.settings.seed;
    estimate.settings.seed += numberOf(side);
    addMeasuredHazards(estimate, measured, poll);
    addHazards(estimate, estimate.settings.hazardRate, poll);
    estimate.settings.seed = seed;
}

}  // namespace

MeasuredBins measuredOnSide(Side side, const TwoTrackReadings& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const Heights& ceiling,
                            const Settings& settings)
{
    const RobotModel plane = inSidePlane(robot, s.roll, signOf(side) * robot.lateral.flipperY);
    MeasuredBins measured = measureBins(plane, sideReadings(s, side), arm, ceiling, settings);
    for (std::size_t i = 0; i < std::size_t{kFirstFlipperBin}; ++i)
        if (measured.bin[i] && measured.bin[i]->origin == Origin::Contact) measured.bin[i].reset();
    return measured;
}

GaussianMixture sideDistribution(const SideModels& models, const TwoTrackReadings& s,
                                 const ClearanceModel::SideBins& covered, Method method)
{
    if (!isClosedForm(method))
        throw std::invalid_argument(fmt::format("method {} has no closed form", name(method)));
    Eigen::VectorXd mean(2 * kBins);
    for (const Side side : kSides) {
        const Heights centre =
            modelOf(models, side).predict(sideFeatures(s, side), covered[numberOf(side)]);
        mean.segment<kBins>(firstOf(side)) =
            Eigen::Map<const Eigen::VectorXd>(centre.data(), kBins);
    }
    if (method == Method::Joint)
        return {Eigen::VectorXd::Ones(1), mean, models.left.sideCovariance(models.right, covered)};
    return smoothed(mean,
                    models.left.sideResiduals(models.right, sideFeatures(s, Side::Left), covered));
}

ClearanceModel::SideBins coveredOnSides(const RobotModel& robot, const TwoTrackReadings& s)
{
    return {coveredBins(sideCeiling(robot, s, Side::Left)),
            coveredBins(sideCeiling(robot, s, Side::Right))};
}

TwoTrackEstimate estimateFrom(SidesPrediction prediction, const TwoTrackReadings& s,
                              const SideArms& arms, const RobotModel& robot,
                              const Settings& settings, const Poll& poll)
{
    TwoTrackEstimate estimate;
    std::array<std::vector<MeasuredHazard>, 2> hazards;
    GaussianMixture& distribution = prediction.distribution;
    for (const Side side : kSides) {
        TerrainEstimate& own = estimate.side[numberOf(side)];
        own.settings = settings;
        own.novelty = prediction.novelty;
        own.ceiling = sideCeiling(robot, s, side);
    }
    for (const Side side : kSides) {
        TerrainEstimate& own = estimate.side[numberOf(side)];
        MeasuredBins measured =
            measuredOnSide(side, s, arms[numberOf(side)], robot, own.ceiling, settings);
        addEarlierArm(measured, prediction.earlier[numberOf(side)],
                      prediction.contact[numberOf(side)].has_value());
        hazards[numberOf(side)] =
            applyMeasurements(distribution, firstOf(side), std::move(measured),
                              prediction.contact[numberOf(side)], own);
        warnIfNovel(own);
    }
    for (const Side side : kSides)
        writeBins(distribution, firstOf(side), estimate.side[numberOf(side)]);
    drawBoth(estimate, distribution, settings, poll);
    for (const Side side : kSides) {
        TerrainEstimate& own = estimate.side[numberOf(side)];
        const RobotModel plane = inSidePlane(robot, s.roll, signOf(side) * robot.lateral.flipperY);
        const Proprioception readings = sideReadings(s, side);
        writeTouch(own, pressedBins(plane, readings, own.ceiling));
        writeRemembered(own, prediction.earlier[numberOf(side)], plane, readings);
        addOwnHazards(own, side, hazards[numberOf(side)], poll);
        own = finite(std::move(own), poll);
    }
    return estimate;
}

TwoTrackEstimate reconstructBothSides(const TwoTrackReadings& s, const SideArms& arms,
                                      const RobotModel& robot, const SideModels& models,
                                      const Settings& settings, const Poll& poll,
                                      const std::array<EarlierTouch, 2>& earlier)
{
    requireClosedForm(settings);
    requireFeatures(s, models);
    callPoll(poll);
    return estimateFrom({sideDistribution(models, s, coveredOnSides(robot, s), settings.method),
                         {contactErrorOf(models.left), contactErrorOf(models.right)},
                         models.left.novelty(sideFeatures(s, Side::Left)),
                         earlier},
                        s, arms, robot, settings, poll);
}

}  // namespace terratact
