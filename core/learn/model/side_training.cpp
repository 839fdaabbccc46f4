#include "core/learn/model/side_training.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/learn/data/scene_copies.h"
#include "core/learn/data/side_features.h"
#include "core/learn/model/clearance_training.h"
#include "core/learn/model/surface_rows.h"
#include "core/learn/model/training.h"
#include "core/robot/side_plane.h"

namespace terratact {

namespace {

bool isUsable(const TwoTrackScene& scene)
{
    return absentFeatures(scene.s, Side::Left).none()
        && (knowsHeights(scene.truth[0]) || knowsHeights(scene.truth[1]))
        && !hasTurned(scene.s.differential);
}

void writeRow(SurfaceData& rows, Eigen::Index row, const TwoTrackScene& scene, Side side)
{
    const Eigen::VectorXd features = sideFeatures(scene.s, side);
    for (Eigen::Index d = 0; d < features.size(); ++d)
        rows.features(row, d) = inSteps(features[d], sideFeatureStep(static_cast<std::size_t>(d)));
    const OptionalHeights& truth = scene.truth[side == Side::Left ? 0 : 1];
    const OptionalHeights& sd = scene.truthSd[side == Side::Left ? 0 : 1];
    for (std::size_t i = 0; i < kBins; ++i) {
        const auto bin = static_cast<Eigen::Index>(i);
        rows.heights(row, bin) = inSteps(truth[i].value_or(0.0), kHeightStep);
        rows.heightSd(row, bin) = truth[i] ? inSteps(sd[i].value_or(0.0), kHeightStep) : 0.0;
    }
    rows.unknownBins[static_cast<std::size_t>(row)] = unknownMask(truth);
}

/// Throws std::invalid_argument unless every bin is known in enough scenes to learn it.
void requireKnownBins(const SurfaceData& rows)
{
    for (int bin = 0; bin < kBins; ++bin) {
        std::size_t known = 0;
        for (std::size_t left = 0; left < rows.unknownBins.size(); left += 2)
            if (isKnown(rows.unknownBins, left, bin) || isKnown(rows.unknownBins, left + 1, bin))
                ++known;
        if (known < std::size_t{kMinTrainingRows})
            throw std::invalid_argument(fmt::format(
                "two tracks need at least {} scenes that know the height of bin {:+.1f} "
                "m on one side, found {}",
                kMinTrainingRows, binCentre(bin), known));
    }
}

}  // namespace

double sideFeatureStep(std::size_t feature)
{
    if (feature < kFirstSideCurrent) return kAngleStep;
    return feature < kFirstSideForce ? kCurrentStep : kForceStep;
}

double inSteps(double value, double step)
{
    return std::round(value / step) * step + 0.0;  // no -0
}

SideTrainingSet prepareSides(const std::vector<TwoTrackScene>& scenes)
{
    std::vector<const TwoTrackScene*> usable;
    for (const TwoTrackScene& scene : scenes)
        if (isUsable(scene) && std::ssize(usable) < kMaxSideScenes) usable.push_back(&scene);
    SideTrainingSet set;
    set.leftOut = static_cast<int>(scenes.size() - usable.size());
    TrackCopies copies = withoutCopies(usable);
    usable = std::move(copies.kept);
    set.exactCopies = static_cast<int>(copies.exact);
    set.nearCopies = static_cast<int>(copies.near);
    set.runsWithCopies = std::move(copies.runs);
    if (usable.size() < std::size_t{kMinTrainingRows})
        throw std::invalid_argument(fmt::format(
            "two tracks need at least {} scenes of different places, with heights, and with all "
            "currents and front forces of both sides, found {}",
            kMinTrainingRows, usable.size()));
    set.used = static_cast<int>(usable.size());
    const Eigen::Index rows = 2 * std::ssize(usable);
    set.rows.features.resize(rows, Eigen::Index{kSideFeatures});
    set.rows.heights.resize(rows, kBins);
    set.rows.heightSd.resize(rows, kBins);
    set.rows.unknownBins.resize(static_cast<std::size_t>(rows));
    for (Eigen::Index k = 0; k < std::ssize(usable); ++k) {
        const TwoTrackScene& scene = *usable[static_cast<std::size_t>(k)];
        writeRow(set.rows, 2 * k, scene, Side::Left);
        writeRow(set.rows, 2 * k + 1, scene, Side::Right);
        if ((unknownMask(scene.truth[0]) | unknownMask(scene.truth[1])) != 0) ++set.withHoles;
    }
    requireKnownBins(set.rows);
    if (set.withHoles == 0) set.rows.unknownBins.clear();
    if ((set.rows.heightSd.array() == 0.0).all()) set.rows.heightSd.resize(0, 0);
    return set;
}

void finishSides(SurfaceData& sides, const RobotModel& robot, const Poll& poll)
{
    keepRows(sides, Eigen::Index{2} * kKeptScenes);
    sides.clearance.residuals = sides.clearance.residuals.unaryExpr(
        [](double residual) { return inSteps(residual, kResidualStep); });
    finishClearance(sides, bodyCeilings(sides.features, robot, poll), robot, poll);
}

}  // namespace terratact
