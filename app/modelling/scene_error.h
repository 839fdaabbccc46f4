#pragma once

#include <array>
#include <optional>

#include "core/infer/estimate/two_track_estimate.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Error of an estimate against the true heights that are known.
struct SceneError {
    int bins = 0;                     ///< bins with a known truth, of both sides
    double median = 0.0, mean = 0.0;  ///< [m] of |height − truth| over these bins
    double largest = 0.0;             ///< [m]
    bool operator==(const SceneError&) const = default;
};

/// Returns the error of both sides, left and right. Sides of one plane with equal truth count once. Empty if no height
/// is known. The median of an even number is the mean of the middle two.
std::optional<SceneError> sceneError(const TwoTrackEstimate& estimate,
                                     const std::array<OptionalHeights, 2>& truth);

/// Returns the number of known heights: those of both sides, once where the sides are equal.
int knownHeights(const std::array<OptionalHeights, 2>& truth);

}  // namespace terratact
