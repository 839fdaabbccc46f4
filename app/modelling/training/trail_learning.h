#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_model.h"
#include "core/trail/trail_training.h"

namespace terratact {

/// Input and options of a training of trail networks.
struct TrailPlan {
    RobotModel robot;
    /// CSV of drives in one plane, and on two tracks, of which the measured ones have sd; empty: none.
    std::vector<std::string> drives{}, trackDrives{};
    std::string commandLine;  ///< stored in the file
    std::uint64_t seed = 1;
    TrailOptions options{};
};

/// Learns the networks of the plane and of the sides (core/trail/trail_training.h), on all processors. notice: receives
/// a sentence for each stage and for drives that are left out as copies (core/learn/data/drive_copies.h). It also
/// receives one for scenes that repeat a place of an earlier drive (core/learn/data/scene_copies.h). Errors name the
/// file, and the line if known. The same files and seed give the same networks.
Result<TrailData> learnTrail(const TrailPlan& plan,
                             const std::function<void(const std::string&)>& notice);

}  // namespace terratact
