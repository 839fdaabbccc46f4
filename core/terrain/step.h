#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/terrain/bins.h"

namespace terratact {

/// Step limit [m]: a larger difference between a bin and the next one, or the one after, is a step.
/// A tracked robot takes lower steps easily. This is the default of the operator's own limit
/// (Preferences::obstacleLimit).
inline constexpr double kStepLimit = 0.10;

/// Number of bins from the foot of a step to its top. An edge within a bin gives it an intermediate
/// mean height, so that only its neighbours show the step's height. An edge between bins shows in
/// the two bins beside it.
inline constexpr int kStepBins = 2;

/// The rearmost bin that counts as ahead of the robot: +0.3 m.
inline constexpr int kFirstAhead = 6;

/// Returns true if bins i < j ≤ i + kStepBins of firstBin … lastBin differ by more than `limit`
/// [m]. Expects 0 ≤ firstBin and lastBin ≤ 10.
inline bool hasStep(const Heights& heights, double limit, int firstBin = 0, int lastBin = kBins - 1)
{
    for (int i = firstBin; i < lastBin; ++i)
        for (int j = i + 1; j <= std::min(i + kStepBins, lastBin); ++j)
            if (std::abs(heights[static_cast<std::size_t>(j)]
                         - heights[static_cast<std::size_t>(i)])
                > limit)
                return true;
    return false;
}

}  // namespace terratact
