#include "app/modelling/simulation/driven_grounds.h"

#include <algorithm>
#include <random>

#include "core/learn/data/profile_file.h"
#include "core/sim/ground/random_terrain.h"

namespace terratact {

Result<std::vector<TerrainProfile>> drivenGrounds(const DrivenGrounds& from, std::size_t most)
{
    std::vector<TerrainProfile> grounds;
    if (from.terrain == "varied") {
        std::mt19937_64 rng(from.seed);
        grounds.reserve(most);
        for (std::size_t k = 0; k < most; ++k) grounds.push_back(randomVariedTerrain(rng));
        return grounds;
    }
    auto file = readProfiles(from.terrain, from.step, from.blocks);
    if (!file) return file.error();
    const auto& all = file->profiles;
    const std::size_t count = std::min(most, all.size());
    grounds.reserve(count);
    for (std::size_t k = 0; k < count; ++k) grounds.push_back(all[k * all.size() / count]);
    return grounds;
}

}  // namespace terratact
