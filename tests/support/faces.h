#pragma once

#include <algorithm>
#include <cmath>

#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Returns the height [m] of the tallest vertical face, up or down; 0 for none.
inline double tallestFace(const TerrainProfile& t)
{
    double tallest = 0.0;
    for (std::size_t i = 1; i < t.points().size(); ++i)
        if (t.points()[i].x == t.points()[i - 1].x)
            tallest = std::max(tallest, std::abs(t.points()[i].z - t.points()[i - 1].z));
    return tallest;
}

}  // namespace terratact
