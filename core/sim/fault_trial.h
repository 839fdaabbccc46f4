#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/learn/data/scene.h"
#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor_suspicion.h"
#include "core/sim/watched_drive.h"

namespace terratact {

/// A fault that SensorWatch is tried on.
struct TriedFault {
    std::string_view fault;  ///< as sensorFaultFrom() reads it; empty: none
    std::string_view words;  ///< for the table
    std::string_view limit;  ///< why SensorWatch cannot notice it in most drives; empty: it does
};

/// No fault, and then every kind of fault at every kind of sensor.
std::span<const TriedFault> triedFaults();

/// A scene that a console makes of the first line of a press.
struct WatchedScene {
    Scene scene;
    Measurement measurement;
    bool isSuspect =
        false;  ///< some suspicion stood at that line, or during the first seconds of the press
};

/// What SensorWatch says of one drive.
struct WatchedFault {
    std::vector<WatchedScene> scenes;
    std::optional<double> noticed;       ///< [s] since the start
    std::size_t scenesUntilNoticed = 0;  ///< that one among them
    std::vector<SensorSuspicion> first;  ///< what it said then
};

/// The lines as a robot with that fault sends them, and what SensorWatch says.  number: of the drive; names its run
/// and seeds the fault.  Throws std::invalid_argument for a text that sensorFaultFrom() does not read.
WatchedFault watchFault(std::span<const WatchedLine> drive, const RobotModel& robot,
                        std::string_view fault, std::size_t number);

}  // namespace terratact
