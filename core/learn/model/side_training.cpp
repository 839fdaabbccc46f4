#include "core/learn/model/side_training.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/learn/data/side_features.h"
#include "core/learn/model/clearance_training.h"
#include "core/learn/model/training.h"

namespace terratact {

namespace {

constexpr double kTurnedDifferential = 0.02;  // [rad]

bool isComplete(const TwoTrackScene& scene)
{
    const auto known = [](const OptionalHeights& heights) {
        return std::ranges::all_of(heights, [](const auto& h) { return h.has_value(); });
    };
    return absentFeatures(scene.s, Side::Left).none() && known(scene.truth[0])
        && known(scene.truth[1])
        && std::abs(scene.s.differential.value_or(0.0)) <= kTurnedDifferential;
}

void writeRow(SurfaceData& rows, Eigen::Index row, const TwoTrackScene& scene, Side side)
{
    const Eigen::VectorXd features = sideFeatures(scene.s, side);
    for (Eigen::Index d = 0; d < features.size(); ++d)
        rows.features(row, d) = inSteps(features[d], sideFeatureStep(static_cast<std::size_t>(d)));
    const OptionalHeights& truth = scene.truth[side == Side::Left ? 0 : 1];
    for (Eigen::Index i = 0; i < kBins; ++i)
        rows.heights(row, i) = inSteps(*truth[static_cast<std::size_t>(i)], kHeightStep);
    const OptionalHeights& sd = scene.truthSd[side == Side::Left ? 0 : 1];
    for (Eigen::Index i = 0; i < kBins; ++i)
        rows.heightSd(row, i) = inSteps(sd[static_cast<std::size_t>(i)].value_or(0.0), kHeightStep);
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
    std::vector<const TwoTrackScene*> complete;
    for (const TwoTrackScene& scene : scenes)
        if (isComplete(scene) && std::ssize(complete) < kMaxSideScenes) complete.push_back(&scene);
    if (complete.size() < std::size_t{kMinTrainingRows})
        throw std::invalid_argument("two tracks need at least 30 scenes with all heights, currents "
                                    "and front forces of both sides");
    SideTrainingSet set;
    set.used = static_cast<int>(complete.size());
    set.leftOut = static_cast<int>(scenes.size()) - set.used;
    const Eigen::Index rows = 2 * std::ssize(complete);
    set.rows.features.resize(rows, Eigen::Index{kSideFeatures});
    set.rows.heights.resize(rows, kBins);
    set.rows.heightSd.resize(rows, kBins);
    for (Eigen::Index k = 0; k < std::ssize(complete); ++k) {
        const TwoTrackScene& scene = *complete[static_cast<std::size_t>(k)];
        writeRow(set.rows, 2 * k, scene, Side::Left);
        writeRow(set.rows, 2 * k + 1, scene, Side::Right);
    }
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
