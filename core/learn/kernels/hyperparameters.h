#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/robot/measurement.h"

namespace terratact {

/// Measurements that a model conditions on.
///   Pa   pitch, front and rear flipper angle
///   Paf  Pa + front and rear current + six forces
enum class FeatureSet : std::uint8_t { Pa, Paf };

/// Returns "pa" or "paf".
std::string_view name(FeatureSet set);

/// Returns the names of the features of s in order, as the columns of a scenes file.
std::vector<std::string_view> featureNames(FeatureSet set);

/// Returns s as a vector in that order. Throws std::invalid_argument that names the first missing
/// value.
Eigen::VectorXd features(FeatureSet set, const Proprioception& s);

/// Returns s in the order of FeatureSet::Paf, with 0 for a missing feature.
Eigen::VectorXd knownFeatures(const Proprioception& s);

/// Returns the first feature of the set that s lacks; empty if it lacks none.
std::string_view missingFeature(FeatureSet set, const Proprioception& s);

/// Hyperparameters of the squared exponential kernel with one length scale per input (ARD). It is the
/// covariance function of every process; maximiseLikelihood() learns them (core/learn/model/training.h).
///   k(x, x') = σ_f² exp(−½ Σ_d (x_d − x'_d)² / ℓ_d²) + σ_n² [same row]; inputs standardised.
/// Source: Rasmussen & Williams (2006), eq. 5.1, with the ½ written out.
struct Hyperparameters {
    Eigen::VectorXd lengthScale;  ///< ℓ_d > 0, in standard deviations of the input; size d
    double signalSd = 1.0;        ///< σ_f > 0 [m]
    double noiseSd = 0.1;         ///< σ_n ≥ 0 [m]
};

}  // namespace terratact
