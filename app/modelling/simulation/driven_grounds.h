#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Where the grounds of simulated drives come from.
struct DrivenGrounds {
    std::string terrain =
        "varied";            ///< "varied" (core/sim/ground/random_terrain.h) or a CSV of profiles
    double step = 0.1;       ///< [m] spacing of the heights in a file
    bool blocks = false;     ///< heights of a file are flat-topped blocks
    std::uint64_t seed = 1;  ///< of random grounds
};

/// Returns at most `most` grounds: random ones, or profiles of the file at equal distances in it.
Result<std::vector<TerrainProfile>> drivenGrounds(const DrivenGrounds& from, std::size_t most);

}  // namespace terratact
