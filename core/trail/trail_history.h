#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "core/infer/estimate/touch.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Places at which a history knows the attitude: 0.1 m, 0.2 m … behind the scene along the tracks.
inline constexpr std::size_t kTrailPlaces = 10;
inline constexpr double kTrailPlaceStep = 0.1;  ///< [m]

/// Length of the way before a scene that a history covers [m].
inline constexpr double kTrailReach = 1.2;

/// Bins for which a history holds where the robot passed and pressed: −0.3 … 0.5 m.
inline constexpr std::size_t kTrailBins = 9;

/// Vertical planes of a history: the middle of the robot, its left and its right side. `lowest` of a
/// side is in the plane of its track, `pressed` in that of its flipper.
inline constexpr std::size_t kTrailPlanes = 3;

/// Memory of the way before a scene in one vertical plane. Heights are in the DEM frame of the scene
/// [m], carried by dead reckoning.
struct TrailGround {
    /// Mean over the bin of the lowest position of the robot above it; +infinity: the robot did not
    /// pass above the whole bin.
    std::array<double, kTrailBins> lowest{};
    /// Load of the force elements that pressed near the bin at earlier scenes [N]. Each force
    /// counts by 1 at the bin's centre, falling linearly to 0 at 0.1 m.
    std::array<double, kTrailBins> load{};
    std::array<double, kTrailBins>
        pressed{};  ///< mean height of these elements by load; 0 without load
    /// Parts of these bins that the front flippers felt at earlier scenes (pressedStretches()). Of the
    /// middle: where both sides were felt, if the robot reports both sides.
    FeltCells felt{};
    /// Heights that the arm measured at earlier scenes, and their sd with that of the way [m]. An sd of 0: none.
    Heights armHeight{}, armSd{};
    bool operator==(const TrailGround&) const = default;
};

/// Memory of the way before a scene. It is plain numbers, so that a session can hold them and estimate
/// again. `way` is its length.
struct TrailHistory {
    double way = 0.0;                          ///< [m] known before the scene, at most kTrailReach
    int presses = 0;                           ///< scenes on this way, without the scene itself
    std::array<double, kTrailPlaces> pitch{};  ///< [rad] mean within ± 0.05 m of each place
    std::array<double, kTrailPlaces> roll{};   ///< [rad] the same of roll, left side up positive
    std::array<TrailGround, kTrailPlanes> ground{};  ///< middle, left, right
    bool operator==(const TrailHistory&) const = default;
};

/// Returns true if the history covers a way, so that an estimate can use it.
constexpr bool isUsable(const TrailHistory& history)
{
    return history.way > 0.0;
}

/// Returns the history of a scene before which nothing is known.
TrailHistory emptyHistory(double pitch, double roll);

}  // namespace terratact
