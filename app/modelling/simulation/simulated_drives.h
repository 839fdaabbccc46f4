#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/modelling/simulation/driven_grounds.h"
#include "core/base/result.h"
#include "core/learn/data/drive_file.h"
#include "core/robot/robot_model.h"
#include "core/sim/way_drive.h"

namespace terratact {

/// Drives to simulate, with telemetry on the way (core/sim/way_drive.h).
struct SimulatedDrives {
    DrivenGrounds grounds;  ///< also the seed of drives and noise
    int drives = 1;         ///< number over random ground; of a file at most so many
    bool tracks = false;  ///< on ground under two tracks: randomGround(), or a file of ground lines
    WayDriveOptions way{};
    double softDrives = 0.0;                ///< share of drives over soft ground
    bool exactTruth = false;                ///< no scanner noise on the true heights
    int threads = 0;                        ///< maximum number; 0: processors()
    std::size_t maxLines = kMaxDriveLines;  ///< of the file
};

struct DriveRecording {
    /// Content of the file (core/learn/data/drive_file.h): the header, and the lines of each drive.
    std::vector<std::string> parts;
    std::size_t drives = 0;  ///< with lines
    std::size_t lines = 0, scenes = 0;
    int skipped = 0;  ///< stops without a rest pose
};

/// Simulates the drives in parallel. The seed and a drive's number seed its generator, so the result does not depend on
/// the number of threads. Runs are named by the number of the drive, or of the ground in the file, from 1. Errors:
/// those of the file, and more than maxLines lines. The second error comes early and states how many drives fit.
Result<DriveRecording> simulateDrives(const RobotModel& robot, const SimulatedDrives& options);

}  // namespace terratact
