#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/infer/estimate/estimate.h"

namespace terratact {

/// Draws that fall into two heaps: up on the step or down on the floor, hardly ever between.
struct TwoModes {
    double split = 0.0;                      ///< [m] midway between the heaps' nearest draws
    double lowMean = 0.0, highMean = 0.0;    ///< [m]
    double lowShare = 0.0, highShare = 0.0;  ///< of the draws; their sum is 1
    double betweenShare = 0.0;               ///< of the variance, explained by the two means
    bool operator==(const TwoModes&) const = default;
};

/// What makes two heaps.  The best split of a normal explains 2/π = 0.637 of its variance, of a uniform 0.75.
inline constexpr double kMinBetweenShare = 0.85;
inline constexpr double kMinModeShare = 0.10;
inline constexpr double kMinModeDistance = 0.06;  ///< [m]

/// The split of the sorted draws into x ≤ split < y that explains most of their variance (2-means in one
/// dimension, exact),
///   betweenShare = max_k n_low n_high (highMean − lowMean)² / (n Σ (x − mean)²),
/// if it exceeds kMinBetweenShare, both classes hold at least kMinModeShare, and their means are
/// more than kMinModeDistance apart; else, and for draws that are all equal or none, empty.
/// draws: [m], any order.  Throws std::invalid_argument for one that is not finite.
/// Source: Fisher, "On grouping for maximum homogeneity", J. Am. Stat. Assoc. 53 (1958).
std::optional<TwoModes> twoModes(std::vector<double> draws);

/// Of every bin; empty, too, for one of which a draw is not finite.
std::array<std::optional<TwoModes>, kBins> twoModes(const TerrainEstimate& estimate);

}  // namespace terratact
