#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/robot/robot_model.h"
#include "core/trail/trail_training.h"

namespace terratact {

/// Input and options of a training of trail networks.
struct TrailPlan {
    RobotModel robot;
    std::string drives;       ///< CSV of drives in one plane; empty: none
    std::string trackDrives;  ///< CSV of drives on two tracks; empty: none
    std::string commandLine;  ///< stored in the file
    std::uint64_t seed = 1;
    TrailOptions options{};
};

/// Learns the networks of the plane and of the sides (core/trail/trail_training.h), on all processors. notice: receives
/// a sentence for each stage. Errors name the file, and the line if known. The same files and seed give the same
/// networks.
Result<TrailData> learnTrail(const TrailPlan& plan,
                             const std::function<void(const std::string&)>& notice);

}  // namespace terratact
