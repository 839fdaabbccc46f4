#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/robot/measurement.h"

namespace terratact {

/// Which measurements a model conditions on.
///   Pa   pitch, front and rear flipper angle
///   Paf  Pa + front and rear current + six forces
enum class FeatureSet : std::uint8_t { Pa, Paf };

/// "pa", "paf".
std::string_view name(FeatureSet set);

/// Names of the features of s in order, as the scenes file calls its columns.
std::vector<std::string_view> featureNames(FeatureSet set);

/// s as a vector in that order.  Throws std::invalid_argument naming the first missing value.
Eigen::VectorXd features(FeatureSet set, const Proprioception& s);

/// s in the order of FeatureSet::Paf, 0 where it lacks a feature.
Eigen::VectorXd knownFeatures(const Proprioception& s);

/// The first feature of the set that s does not have; empty where it has all.
std::string_view missingFeature(FeatureSet set, const Proprioception& s);

/// k(x, x') = σ_f² exp(−½ Σ_d (x_d − x'_d)² / ℓ_d²) + σ_n² [same row]; inputs standardised.
/// (Rasmussen & Williams 2006, eq. 5.1, the ½ written out.)
struct Hyperparameters {
    Eigen::VectorXd lengthScale;  ///< ℓ_d > 0, in standard deviations of the input; size d
    double signalSd = 1.0;        ///< σ_f > 0 [m]
    double noiseSd = 0.1;         ///< σ_n ≥ 0 [m]
};

}  // namespace terratact
