#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/learn/data/scene.h"
#include "core/robot/two_tracks.h"
#include "core/terrain/bins.h"

namespace terratact {

/// One measured scene of a robot with two tracks.
struct TwoTrackScene {
    std::string run;    ///< drive that it belongs to
    double time = 0.0;  ///< [s] since the drive's start
    TwoTrackReadings s;
    std::array<OptionalHeights, 2> truth{};    ///< left, right: sideHeights() of each side
    std::array<OptionalHeights, 2> truthSd{};  ///< [m] sd of each true height; empty: exact
    bool operator==(const TwoTrackScene&) const = default;
};

/// Returns a scene of one plane as one of two tracks: roll 0, and every reading and height on both
/// sides.
TwoTrackScene onBothSides(const Scene& scene);
std::vector<TwoTrackScene> onBothSides(const std::vector<Scene>& scenes);

/// Returns a scene with left and right exchanged.
TwoTrackScene mirrored(const TwoTrackScene& scene);

}  // namespace terratact
