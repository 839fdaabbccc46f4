#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/clouds/made_cloud.h"
#include "core/learn/data/two_track_scene.h"
#include "core/robot/two_tracks.h"
#include "core/store/file_group.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

/// Laser map of simulated drives: a cloud of their ground and the poses of their scenes, for terratact truth.
struct SimulatedMapOptions {
    std::string cloud;        ///< PCD file to write; empty: no map
    std::string poses;        ///< CSV of poses to write
    std::string recording{};  ///< MCAP to write (simulated_recording.h); empty: none
    bool floorPoses = false;  ///< the recording ends with poses that calibrate a robot file
    MadeCloud made{};
    double tilt = 0.0;  ///< [rad] of the whole map, cloud and poses, about its y axis
    std::uint64_t seed = 1;
};

/// Collects drives and lays them out beside each other, each with a heading of its own.
class SimulatedMap {
public:
    explicit SimulatedMap(SimulatedMapOptions options) : options_(std::move(options)) {}

    bool isWanted() const { return !options_.cloud.empty(); }

    /// Adds a drive: its poses and its scenes, as many as poses. Throws std::invalid_argument otherwise.
    void add(const std::string& run, const GroundLines& ground, std::vector<TwoTrackPose> poses,
             std::vector<TwoTrackScene> scenes);

    /// Adds cloud, poses and recording to `files`. Returns the number of points. Errors name the file.
    Result<std::size_t> write(const RobotModel& robot, FileGroup& files) const;

private:
    struct Drive {
        std::string run;
        GroundLines ground;
        std::vector<TwoTrackPose> poses;
        std::vector<TwoTrackScene> scenes;
        double begin = 0.0, end = 0.0;  ///< [m] of the ground that is seen
    };
    CloudPose placeOf(std::size_t drive) const;

    SimulatedMapOptions options_;
    std::vector<Drive> drives_;
};

}  // namespace terratact
