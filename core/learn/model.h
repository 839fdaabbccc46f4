#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>

#include "core/learn/hyperparameters.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Everything eleven conditionals p(hᵢ | h_{J∖i}, s) are made of: what a model file holds.  Input of the
/// i-th: the ten other bins rear to front, then the features of s.
///   standardised input x_d = (raw_d − mean_d) / sd_d, centred output y = hᵢ − heightMean_i.
struct BinModelData {
    FeatureSet set = FeatureSet::Pa;
    Eigen::VectorXd mean, sd;  ///< size 11 + f: of the eleven heights [m], then of the f features
    std::array<Hyperparameters, kBins> bins;
    std::array<double, kBins> logLikelihood{};  ///< of the training set
};

/// A trained model: both feature sets over the same training rows.
struct ModelData {
    Eigen::MatrixXd heights;  ///< U × 11 [m]
    Eigen::MatrixXd
        features;  ///< U × 11, order of featureNames(Paf); Pa uses the first three columns
    BinModelData pa, paf;
    std::string command;  ///< how it was made
    std::uint64_t seed = 0;
    std::string dataHash;  ///< SHA-256 of the scenes it was trained on, hex
};

}  // namespace terratact
