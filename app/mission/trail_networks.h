#pragma once

#include <QString>
#include <memory>
#include <string>

#include "core/base/message.h"
#include "core/robot/robot_model.h"
#include "core/trail/trail_model.h"

namespace terratact {

/// Texts about the networks of the method trail that belong to a model.
struct TrailInUse {
    QString name{}, hash{};  ///< "default.ttn", SHA-256 of the file; empty: there are none
    Message trouble{};       ///< reason that there are none
    bool operator==(const TrailInUse&) const = default;
};

struct LoadedTrail {
    std::shared_ptr<const TrailModel> model{};  ///< null: there are none
    TrailInUse about{};
};

/// Reads the networks beside a model file (trailPathBeside()). The shipped ones learnt from drives of the shipped
/// robot: another robot has none. It takes tens of milliseconds: call it in the worker's thread.
LoadedTrail trailBeside(const std::string& modelPath, const RobotModel& robot);

/// Returns true if both robots have the same shape, masses and force elements, so that the same networks serve them.
bool fitSameNetworks(const RobotModel& a, const RobotModel& b);

}  // namespace terratact
