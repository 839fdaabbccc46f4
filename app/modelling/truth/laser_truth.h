#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/modelling/truth/truth_errors.h"
#include "core/base/result.h"
#include "core/clouds/cloud_alignment.h"
#include "core/clouds/cloud_truth.h"
#include "core/clouds/pose_track.h"
#include "core/clouds/scene_grid.h"
#include "core/learn/data/drive_lines.h"
#include "core/learn/data/scene.h"
#include "core/learn/data/two_track_scene.h"

namespace terratact {

struct LaserTruthOptions {
    std::string robot;                ///< robot file
    std::string scenes;               ///< CSV of scenes or drives, of one plane or of two tracks
    std::vector<std::string> clouds;  ///< files
    std::string poses;                ///< TUM, CSV, or with `mapping` a recording
    std::string mapping;              ///< says where poses are in a recording
    std::string topic;      ///< non-empty: clouds are recordings with PointCloud2 messages
    bool scans = false;     ///< clouds are in the sensor's frame, named by their times
    CloudPose poseMount{};  ///< pose of the frame of `poses` in the base
    std::optional<CloudPose>
        sensorMount{};  ///< pose of the sensor in the base; else as tfBase says
    std::string
        tfBase{};  ///< frame of the base: sensors of `topic` are placed by transforms. Empty: that of the
                   ///< mapping, if it takes poses from transforms, else the sensor is at the base
    std::string run;                ///< the only run; empty: all
    std::optional<double> start{};  ///< [s] of the poses' clock at t_s = 0
    std::string session;            ///< whose begin is `start`
    PoseLimits limits{};
    TruthRule rule{};
    bool align = false;  ///< offset and tilt are removed
};

/// Why a scene has no heights.
enum class TruthGap : std::uint8_t {
    None,
    OtherRun,  ///< `run` names another one
    NoPose,    ///< no poses around its time
    OffCloud,  ///< the robot lies far above or below the cloud there: a pose that jumps
    NoCloud,   ///< no bin is known well enough
    Excluded,  ///< a person left it out (truth_decisions.h)
};

/// Heights of one scene, and what they rest on.
struct SceneTruth {
    TruthGap gap = TruthGap::NoPose;
    std::size_t place = 0;                   ///< of the grid, unless `gap` is OtherRun or NoPose
    CloudCorrection correction{};            ///< that was applied
    std::optional<CloudCorrection> contact;  ///< that would let the robot rest on the cloud
    std::array<SideTruth, 2> side{};         ///< left, right
    SideTruth plane{};                       ///< of a file of one plane

    bool hasPlace() const { return gap != TruthGap::OtherRun && gap != TruthGap::NoPose; }
};

struct LaserTruth {
    RobotModel robot;
    bool isPlane = false;
    /// Scenes of the file in its order with heights of the cloud; those of two tracks, or of one plane.
    std::vector<TwoTrackScene> tracks{};
    std::vector<Scene> plane{};
    /// Of a file of drives: every line. Their scenes are the scenes above, in this order; their heights are not kept
    /// up.
    std::vector<DriveLines> drives{};
    std::vector<SceneTruth> truths{};
    std::optional<SceneGrid> grid{};
    TruthRule rule{};  ///< with the sd of the place
    std::optional<CloudAlignment> alignment{};
    std::size_t clouds = 0;                 ///< files, or messages of a topic
    std::uint64_t points = 0, leftOut = 0;  ///< read; not finite
    TruthErrors under{}, ahead{};           ///< bins −0.3 … 0.2 m, and from 0.3 m on
    std::vector<std::string> remarks{};

    std::size_t scenes() const { return truths.size(); }
    const std::string& runOf(std::size_t row) const;
    double timeOf(std::size_t row) const;
    std::size_t count(TruthGap gap) const;
    std::size_t knownHeights() const;
};

/// Returns the heights of every scene from clouds and poses. Errors name the file, the line and what to do: a file
/// cannot be read, no scene has a pose because clocks differ, or no point lies near a scene.
Result<LaserTruth> laserTruth(const LaserTruthOptions& options);

}  // namespace terratact
