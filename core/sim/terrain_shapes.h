#pragma once

#include <random>
#include <vector>

#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Level ground at z = 0 from x = 0 to `length`.
TerrainProfile flatTerrain(double length);

/// Level ground, a vertical face of `height` [m] (down if negative) at x = `at`, level on to `length`.
TerrainProfile stepTerrain(double height, double at, double length);

/// A box of `height` and `width` [m] that begins at x = `at` on level ground.
TerrainProfile boxTerrain(double height, double at, double width, double length);

/// `count` equal stairs going up (down if riser is negative) from x = `at`.
TerrainProfile stairsTerrain(double riser, double tread, int count, double at, double length);

/// Level ground that turns into a slope of `angle` [rad] at x = `at`.
TerrainProfile slopeTerrain(double angle, double at, double length);

/// Rough ground: a stationary first-order Gaussian process of sd [m] and correlation length [m], posts
/// every 10 mm.
TerrainProfile roughTerrain(double sd, double correlation, double length, std::mt19937_64& rng);

/// The sum of two profiles' heights at every point of either; vertical faces are kept.
TerrainProfile sum(const TerrainProfile& a, const TerrainProfile& b);

/// The ground of the demonstration: uneven floor, a step of 0.24 m (a height no box of the paper's
/// training set has) at x = kDemoStep, a landing, stairs down.
inline constexpr double kDemoStep = 2.6;  ///< [m]
TerrainProfile demoTerrain();

}  // namespace terratact
