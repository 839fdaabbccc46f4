#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/modelling/simulation/simulated_map.h"
#include "core/base/result.h"
#include "core/learn/data/scene.h"
#include "core/learn/data/two_track_scene.h"
#include "core/robot/robot_model.h"
#include "core/sim/disturbance.h"
#include "core/sim/sensor_fault.h"

namespace terratact {

/// Drives to simulate that stop, press and measure; nothing is recorded between the stops.
struct SimulatedScenes {
    /// "boxes": 28 drives over the boxes of the paper; "varied": random ground, a drive for every 8 scenes; "hazards":
    /// a drive for every 16 scenes. Any other text is the path of a file of profiles or ground lines.
    std::string terrain = "boxes";
    std::uint64_t seed = 1;     ///< of grounds, drives and noise
    int count = 0;              ///< number of stops; 0: 1400 for presets, every stop of a file
    double step = 0.1;          ///< [m] spacing of the heights in a file
    bool blocks = false;        ///< heights of a file are flat-topped blocks
    bool exactTruth = false;    ///< no scanner noise on the true heights
    double softDrives = 0.0;    ///< share of drives over soft ground
    SimulatedMapOptions map{};  ///< laser map of the drives
    // Of one plane only:
    Disturbance disturbance = Disturbance::None;
    std::optional<SensorFault> sensorFault{};  ///< acts on every drive from its start
};

/// Scenes of simulated drives, in the order of the drives. AnyScene: Scene or TwoTrackScene.
template <class AnyScene>
struct DrivenScenes {
    std::vector<AnyScene> scenes{};
    int skipped = 0;  ///< stops without a rest pose
    SimulatedMap map;
};

/// Simulates the drives of a robot on one plane (core/sim/drive.h). The stops of a preset are spread evenly over its
/// drives, and over the ground of each. Stops over a file are 0.1 m apart. `count` of them are chosen at random and keep
/// their order. Runs are named by the number of the drive or of the profile, from 1. The seed determines the
/// result. Errors: those of the file.
Result<DrivenScenes<Scene>> simulateScenes(const RobotModel& robot, const SimulatedScenes& options);

/// Does the same on ground under two tracks (core/sim/two_track_drive.h): on random ground, or over a file of ground
/// lines. Throws std::invalid_argument for a sensor fault; a disturbance has no effect.
Result<DrivenScenes<TwoTrackScene>> simulateTrackScenes(const RobotModel& robot,
                                                        const SimulatedScenes& options);

}  // namespace terratact
