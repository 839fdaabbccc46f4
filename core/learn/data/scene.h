#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/robot/measurement.h"
#include "core/terrain/bins.h"

namespace terratact {

/// One measured scene: the proprioception and, if known, the true terrain.
struct Scene {
    std::string run;    ///< drive that it belongs to
    double time = 0.0;  ///< [s] since the drive's start
    Proprioception s;
    OptionalHeights truth{};
    OptionalHeights truthSd{};  ///< [m] sd of each true height; empty: exact
    bool operator==(const Scene&) const = default;
};

/// Returns a bit mask: bit i is set if height i is unknown.
inline unsigned unknownMask(const OptionalHeights& heights)
{
    unsigned mask = 0;
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (!heights[i]) mask |= 1U << i;
    return mask;
}

/// Returns true if at least one height is known.
inline bool knowsHeights(const OptionalHeights& heights)
{
    return unknownMask(heights) != (1U << heights.size()) - 1U;
}

}  // namespace terratact
