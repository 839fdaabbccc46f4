#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/infer/estimate/estimate.h"

namespace terratact {

/// Draws in two clusters, for example on a step and on the floor below, with few between.
struct TwoModes {
    double split = 0.0;                      ///< midway between the clusters' nearest draws [m]
    double lowMean = 0.0, highMean = 0.0;    ///< mean of each cluster [m]
    double lowShare = 0.0, highShare = 0.0;  ///< share of the draws in each cluster; the sum is 1
    double betweenShare = 0.0;               ///< share of the variance that the two means explain
    bool operator==(const TwoModes&) const = default;
};

/// Least values for two clusters. The best split of a normal explains 2/π = 0.637 of its variance,
/// of a uniform 0.75.
inline constexpr double kMinBetweenShare = 0.85;
inline constexpr double kMinModeShare = 0.10;
inline constexpr double kMinModeDistance = 0.06;  ///< [m]

/// Returns the split into x ≤ split < y that explains most of the draws' variance (exact 2-means in
/// one dimension):
///   betweenShare = max_k n_low n_high (highMean − lowMean)² / (n Σ (x − mean)²)
/// Empty unless betweenShare exceeds kMinBetweenShare and both clusters hold at least
/// kMinModeShare. Also empty if their means are at most kMinModeDistance apart, and for no draws or
/// equal draws. draws: [m], any order. Throws std::invalid_argument for a draw that is not finite.
/// Source: Fisher, "On grouping for maximum homogeneity", J. Am. Stat. Assoc. 53 (1958).
std::optional<TwoModes> twoModes(std::vector<double> draws);

/// Returns the split of every bin; empty also for a bin with a draw that is not finite.
std::array<std::optional<TwoModes>, kBins> twoModes(const TerrainEstimate& estimate);

}  // namespace terratact
