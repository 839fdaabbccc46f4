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

/// Fault for a trial of SensorWatch.
struct TriedFault {
    std::string_view fault;  ///< text that sensorFaultFrom() reads; empty: no fault
    std::string_view words;  ///< text for the table
    std::string_view limit;  ///< why SensorWatch cannot detect it in most drives; empty: it does
};

/// Returns no fault, and then every kind of fault but Lost at every kind of sensor.
std::span<const TriedFault> triedFaults();

/// Scene that a console makes of the first line of a press.
struct WatchedScene {
    Scene scene;
    Measurement measurement;
    /// A sensor was suspected at that line, or during the first seconds of the press.
    bool isSuspect = false;
};

/// Result of SensorWatch for one drive.
struct WatchedFault {
    std::vector<WatchedScene> scenes;
    std::optional<double> noticed;  ///< time of the first suspicion since the start [s]
    /// number of scenes up to and with the one of the first suspicion
    std::size_t scenesUntilNoticed = 0;
    std::vector<SensorSuspicion> first;  ///< first suspicions
};

/// Applies the fault to the drive's lines and runs SensorWatch on them. number: of the drive; it
/// names the run and seeds the fault. Throws std::invalid_argument for a text that
/// sensorFaultFrom() does not read.
WatchedFault watchFault(std::span<const WatchedLine> drive, const RobotModel& robot,
                        std::string_view fault, std::size_t number);

}  // namespace terratact
