#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/learn/data/scene.h"
#include "core/learn/data/two_track_scene.h"
#include "core/robot/measurement.h"
#include "core/terrain/bins.h"

namespace terratact {

/// One line of a drive: telemetry on the way, or a scene with its truth.
struct DriveLine {
    /// Activity: Driving on the way, Pressed in a scene. `travelled` is known.
    Measurement line;
    bool isScene = false;                    ///< the robot stands with pressed flippers
    std::array<OptionalHeights, 2> truth{};  ///< left, right; of one plane equal; empty on the way
    std::array<OptionalHeights, 2> truthSd{};  ///< [m] sd of each true height; empty: exact
    bool operator==(const DriveLine&) const = default;
};

/// Lines of one drive in the order of time.
struct DriveLines {
    std::string run;
    bool onePlane = true;  ///< left and right are equal, and the roll is 0
    std::vector<DriveLine> lines;
    bool operator==(const DriveLines&) const = default;
};

/// Return the scenes of a drive in one plane, left and right averaged, or on two tracks.
std::vector<Scene> planeScenesOf(const DriveLines& drive);
std::vector<TwoTrackScene> trackScenesOf(const DriveLines& drive);

}  // namespace terratact
