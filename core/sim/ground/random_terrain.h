#pragma once

#include <random>

#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Length of every random terrain, from x = 0 [m].
inline constexpr double kRandomTerrainLength = 6.0;

/// Returns one drive of the paper's training set: flat ground, a box of 0.20 m or 0.28 m, flat
/// ground.
TerrainProfile randomBoxTerrain(std::mt19937_64& rng);

/// Returns one drive over varied ground of four kinds, with their shares in brackets:
///   built (50 %)    a row of features without long flats between: single steps 0.03–0.40 m, flights of
///                   2–12 stairs (risers 0.08–0.20 m, treads 0.22–0.40 m), ramps up to 30°, blocks and
///                   ledges 0.04–0.35 m, kerbs, holes, humps; crossed at up to 60° from head-on, which
///                   stretches them; on roughness of ISO 8608 class A to E
///   natural (25 %)  roughness of ISO 8608 class D to G, humps, hollows and single steps
///   rubble (10 %)   a step field: flat-topped posts 0.1–0.3 m wide, up to 0.3 m high
///   overgrown (15 %) built ground under natural roughness
/// Three in ten lie on a slope of up to 20°. Half of them are shown as a 0.1 m elevation map shows
/// ground: cell means joined by straight lines.
TerrainProfile randomVariedTerrain(std::mt19937_64& rng);

/// Returns random roughness with the displacement spectrum of ISO 8608:
///   G(n) = G(n₀) (n / n₀)⁻²,  n₀ = 0.1 cycles/m,  n = 0.25 … 10 cycles/m
/// It is a sum of cosines of random phase, with posts every 20 mm. gn0: G(n₀) [m³]. The geometric
/// mean of class A is 16e-6, and every further class has 4 times that. Its variance is G(n₀) n₀²
/// (1/0.25 − 1/10). Source: ISO 8608:2016, annex C.
TerrainProfile isoRoughness(double gn0, double length, std::mt19937_64& rng);

/// Returns the geometric mean of G(n₀) of an ISO 8608 class [m³]. Class 0 is A; a fraction lies between two classes.
double classRoughness(double roughnessClass);

/// Returns isoRoughness() of a random class between these two.
TerrainProfile randomRoughness(double fromClass, double toClass, std::mt19937_64& rng);

/// Returns the terrain as in an elevation map with cells of `cell` [m]. Straight lines join the
/// cell means at the cells' centres. It is half a cell shorter at both ends.
TerrainProfile asElevationMap(const TerrainProfile& terrain, double cell);

}  // namespace terratact
