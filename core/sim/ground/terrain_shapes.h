#pragma once

#include <random>
#include <vector>

#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Returns level ground at z = 0 from x = 0 to `length`.
TerrainProfile flatTerrain(double length);

/// Returns level ground with a vertical face of `height` [m] (down if negative) at x = `at`, level
/// up to `length`.
TerrainProfile stepTerrain(double height, double at, double length);

/// Returns level ground with a box of `height` and `width` [m] that begins at x = `at`.
TerrainProfile boxTerrain(double height, double at, double width, double length);

/// Returns level ground that becomes a slope of `angle` [rad] at x = `at`.
TerrainProfile slopeTerrain(double angle, double at, double length);

/// Returns rough ground: a stationary first-order Gaussian process of sd [m] and correlation length
/// [m], with posts every 10 mm.
TerrainProfile roughTerrain(double sd, double correlation, double length, std::mt19937_64& rng);

/// Returns the sum of two profiles' heights at every point of either; vertical faces are kept.
TerrainProfile sum(const TerrainProfile& a, const TerrainProfile& b);

inline constexpr double kDemoStep = 2.6;  ///< [m] place of the step in demoTerrain()
/// Returns the ground of the demonstration: uneven floor, a step of 0.24 m at x = kDemoStep, a
/// landing, stairs down. No box of the paper's training set has that height.
TerrainProfile demoTerrain();

}  // namespace terratact
