#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/learn/kernels/hyperparameters.h"
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

/// One bin, open or covered: its surface coordinate y (core/learn/model/clearance.h) as a Gaussian process on
/// s alone, through inducing rows (core/learn/gp/projected_process.h).
///   mean(x) = mean + Σ_k weight_k k(x, z_k);  without weights (too few training rows): mean
struct SurfaceProcess {
    Hyperparameters hyper;
    double mean = 0.0;        ///< of y
    double residualSd = 0.0;  ///< root mean square of the leave-one-out residuals
    Eigen::VectorXd weights;  ///< one per inducing row, see inducingRows()
};

/// What the methods over clearances are made of.
struct ClearanceData {
    Eigen::VectorXd featureMean, featureSd;  ///< of surfaceFeatures(), size 11
    std::array<SurfaceProcess, kBins> open, covered;
    /// Hyper-parameters of the conditionals p(yᵢ | y_{J∖i}, s) of clearance_conditionals.h; no length scales
    /// where a regime had too few rows.
    std::array<Hyperparameters, kBins> conditionalOpen, conditionalCovered;
    std::vector<unsigned> coveredBins;  ///< per training row: bit i where bin i's ceiling is finite
    Eigen::MatrixXd residuals;          ///< U × 11: leave-one-out, of the bin's own process [y]
    double noveltyScale = 0.0;          ///< scene distance that 1 % of the training rows exceed
    double contactBias = 0.0;           ///< [m] mean of true bin height − contact height
    double contactSd = 0.0;             ///< [m] its standard deviation
};

/// A trained model over U training rows.  The conditionals `pa` and `paf` use the first V ≤ U of them, their
/// heights as a scanner reports them; `clearance` uses all.
struct ModelData {
    Eigen::MatrixXd heights;  ///< U × 11 [m]
    Eigen::MatrixXd
        features;  ///< U × 11, order of featureNames(Paf); Pa uses the first three columns
    Eigen::MatrixXd scannedHeights;  ///< V × 11 [m]
    BinModelData pa, paf;
    ClearanceData clearance;
    int inducing = 0;     ///< rows the conditionals predict through, at most; 0: all of theirs
    std::string command;  ///< how it was made
    std::uint64_t seed = 0;
    std::string dataHash;  ///< SHA-256 of the scenes it was trained on, hex
};

}  // namespace terratact
