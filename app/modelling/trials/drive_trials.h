#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "app/modelling/trials/drive_scores.h"
#include "core/base/result.h"
#include "core/infer/estimate/settings.h"

namespace terratact {

/// Way after which the memory of a scene is complete [m]: the robot has rolled over its own length.
inline constexpr double kWholeMemory = 0.85;

struct DriveFindings {
    std::size_t drives = 0;
    std::size_t scenes = 0;          ///< scenes after at least kWholeMemory of way
    std::size_t early = 0;           ///< scenes after less than kWholeMemory of way
    std::size_t failed = 0;          ///< estimates that a method could not make
    std::size_t trainingDrives = 0;  ///< of the networks, as far as their file has marks of drives
    std::size_t trainingScenes = 0;  ///< of the model, and near copies
    std::vector<DriveScores> whole, begin;  ///< scores by method: of `scenes`, and of `early`
};

/// Estimates every scene of a file of drives (core/learn/data/drive_file.h) by each method, and compares the estimates
/// with the truth. Only Trail uses the memory of its drive. Runs on all processors. notice: receives sentences about
/// the file. Errors name the file and the line.
Result<DriveFindings> judgeDriveFile(const std::string& path, const EstimatorBundle& bundle,
                                     const std::vector<Method>& methods, const Settings& settings,
                                     const std::function<void(const Message&)>& notice);

/// Returns a table for the terminal [mm].
std::string driveTable(const DriveFindings& findings);

}  // namespace terratact
