#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "core/robot/robot_model.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

/// Returns the y of a robot's flippers and tracks from left to right [m].
std::vector<double> groundYs(const RobotModel& robot);

/// Kinds of random ground under two tracks, with their shares.
///   Symmetric (15 %)  randomVariedTerrain() (core/sim/ground/random_terrain.h), equal on every line
///   Oblique (35 %)    the same, crossed at up to ±45° from head-on: a line at y is shifted by y tan α
///   OneSided (20 %)   a row of blocks, kerbs and holes of 0.03 … 0.35 m, each on one side. Its inner
///                     edge lies at −0.1 … 0.24 m, and it may be under one flipper alone.
///   Uneven (30 %)     natural ground and rubble with a lateral correlation length of 0.1 … 0.6 m
enum class GroundKind : std::uint8_t { Symmetric, Oblique, OneSided, Uneven };

GroundKind randomGroundKind(std::mt19937_64& rng);

/// Returns random ground of that kind with a line at each y of `ys`, kRandomTerrainLength long. A third
/// lies on a cross slope of up to ±15°. Half of the OneSided and Uneven ground is shown as in a 0.1 m elevation map,
/// like randomVariedTerrain().
GroundLines randomGround(GroundKind kind, const std::vector<double>& ys, std::mt19937_64& rng);

/// Range of lateral correlation lengths L [m]: heights of lines at a distance d correlate by
/// exp(−d / L).
inline constexpr double kMinCorrelation = 0.1, kMaxCorrelation = 0.6;

/// Adds roughness (isoRoughness(), G(n₀) = gn0 [m³]) to lines in the order of their y. Its lateral
/// correlation length is `correlation` [m].
void addRoughness(std::vector<GroundLine>& lines, double gn0, double correlation,
                  std::mt19937_64& rng);

}  // namespace terratact
