#pragma once

#include <cmath>
#include <random>

#include "core/learn/model/clearance_conditionals.h"
#include "core/terrain/body_ceiling.h"
#include "tests/support/toy_model.h"

namespace terratact {

/// Returns the ceilings for rows of features in the order of featureNames(Paf).
inline Eigen::MatrixXd ceilingsOf(const RobotModel& robot, const Eigen::MatrixXd& features)
{
    Eigen::MatrixXd ceilings(features.rows(), kBins);
    for (Eigen::Index u = 0; u < features.rows(); ++u) {
        const Heights c = bodyCeiling(robot, features(u, 0), features(u, 1), features(u, 2));
        ceilings.row(u) = Eigen::Map<const Eigen::RowVectorXd>(c.data(), kBins);
    }
    return ceilings;
}

/// Returns the clearances of a short simulated campaign.
inline ClearanceTraining campaignTraining(int runs = 12, std::uint64_t seed = 1)
{
    const ModelData model = prepareTraining(someScenes(runs, seed)).model;
    return {model.heights, ceilingsOf(absolem(), model.features), model.features, {}};
}

/// Returns plausible hyperparameters, not optimised, for every bin and regime with enough rows.
inline ClearanceConditionalData plausibleConditionals(const ClearanceTraining& training)
{
    ClearanceConditionalData data = prepareClearanceConditionals(training);
    for (int i = 0; i < kBins; ++i)
        for (const Regime regime : kRegimes) {
            ClearanceRegimeData& own = data.at(i, regime);
            if (own.rows < kMinTrainingRows) continue;
            own.hyper = {Eigen::VectorXd::Constant(21, 6.0), own.sd, 0.3 * own.sd};
        }
    return data;
}

/// A world with known joint distribution. z: eleven standard normal numbers; neighbours are correlated by
/// kToyCorrelation, independent of the pose. Covered bins have y = −4 + 0.6 z, open ones height −0.2 + 0.05 z. Currents
/// and forces are noise.
inline constexpr double kToyCorrelation = 0.6;

inline ClearanceTraining knownWorldTraining(int rows, std::uint64_t seed)
{
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> normal;
    ClearanceTraining training;
    training.features.resize(rows, 11);
    for (double& x : training.features.reshaped()) x = 0.1 * normal(rng);
    training.features.rightCols(8) = training.features.rightCols(8).array().abs() * 10.0;
    training.ceilings = ceilingsOf(absolem(), training.features);
    training.heights.resize(rows, kBins);
    const double fresh = std::sqrt(1.0 - kToyCorrelation * kToyCorrelation);
    for (Eigen::Index u = 0; u < rows; ++u) {
        double z = normal(rng);
        for (Eigen::Index i = 0; i < kBins; ++i) {
            const double ceiling = training.ceilings(u, i);
            const bool open = regimeOf(ceiling) == Regime::Open;
            training.heights(u, i) =
                fromLogClearance(open ? -0.2 + 0.05 * z : -4.0 + 0.6 * z, ceiling);
            z = kToyCorrelation * z + fresh * normal(rng);
        }
    }
    return training;
}

}  // namespace terratact
