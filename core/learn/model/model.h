#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/learn/kernels/hyperparameters.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Data of the eleven conditionals p(hᵢ | h_{J∖i}, s), as a model file holds them. Input of the
/// i-th: the ten other bins rear to front, then the features of s.
///   standardised input x_d = (raw_d − mean_d) / sd_d, centred output y = hᵢ − heightMean_i.
struct BinModelData {
    FeatureSet set = FeatureSet::Pa;
    Eigen::VectorXd mean, sd;  ///< size 11 + f: the eleven heights [m], then the f features
    std::array<Hyperparameters, kBins> bins;
    std::array<double, kBins> logLikelihood{};  ///< log likelihood of the training set
};

/// Gaussian process of one bin, open or covered. It predicts the surface coordinate y
/// (core/learn/model/clearance.h) from s alone, through inducing rows
/// (core/learn/gp/projected_process.h).
///   mean(x) = mean + Σ_k weight_k k(x, z_k);  without weights (too few training rows): mean
struct SurfaceProcess {
    Hyperparameters hyper;
    double mean = 0.0;        ///< mean of y
    double residualSd = 0.0;  ///< root mean square of the leave-one-out residuals
    Eigen::VectorXd weights;  ///< one per inducing row, see inducingRows()
};

/// Data of the methods over clearances.
struct ClearanceData {
    Eigen::VectorXd featureMean, featureSd;  ///< for surfaceFeatures(), size f of SurfaceData
    std::array<SurfaceProcess, kBins> open, covered;
    /// Hyperparameters of the conditionals p(yᵢ | y_{J∖i}, s) of clearance_conditionals.h; without
    /// length scales if a regime had too few rows.
    std::array<Hyperparameters, kBins> conditionalOpen, conditionalCovered;
    /// Per training row: bit i is set if bin i's ceiling is finite.
    std::vector<unsigned> coveredBins;
    Eigen::MatrixXd residuals;  ///< U × 11: leave-one-out residuals of the bin's own process [y]
    double noveltyScale = 0.0;  ///< scene distance that 1 % of the training rows exceed
    double contactBias = 0.0;   ///< mean of true bin height − contact height [m]
    double contactSd = 0.0;     ///< standard deviation of that difference [m]
};

/// Training rows of surface processes, and what was learnt from them. There are 11 features
/// (FeatureSet::Paf) for one plane. There are kSideFeatures for one side of a robot with two tracks
/// (core/learn/data/side_features.h). Rows 2k and 2k + 1 are then the left and right side of scene
/// k.
struct SurfaceData {
    Eigen::MatrixXd heights;   ///< U × 11 [m]
    Eigen::MatrixXd features;  ///< U × f, raw
    Eigen::MatrixXd heightSd;  ///< U × 11 [m] sd of each height; without rows: heights are exact
    /// Per row, bit i is set if the height of bin i is unknown. Height, sd and residual are 0 there.
    /// Without entries: all heights are known.
    std::vector<unsigned> unknownBins;
    ClearanceData clearance;
    /// Number of the last rows that measure a place of an earlier row again (scene_copies.h). 0:
    /// every row counts as another place, as in models that older versions wrote.
    int repeats = 0;
};

/// Trained model over U training rows of one plane: features in the order of featureNames(Paf); Pa
/// uses the first three columns. The heights of the first V ≤ U rows are all known, as a scanner
/// reports them. The conditionals `pa` and `paf` use these rows, `clearance` uses all.
struct ModelData : SurfaceData {
    Eigen::MatrixXd scannedHeights;  ///< V × 11 [m]
    BinModelData pa, paf;
    int inducing = 0;     ///< largest number of rows that the conditionals predict through; 0: all
    std::string command;  ///< command that trained it
    std::uint64_t seed = 0;
    std::string dataHash;  ///< SHA-256 of the training scenes, hex
    /// Rows of both sides of a robot with two tracks; without rows: trained for one plane only.
    SurfaceData sides;
    std::string sidesHash;     ///< SHA-256 of the scenes that `sides` learnt from, hex
    std::string sidesCommand;  ///< command that trained `sides`

    bool hasSides() const { return sides.heights.rows() > 0; }
};

}  // namespace terratact
