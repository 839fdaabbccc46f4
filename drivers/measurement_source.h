#pragma once

#include <array>
#include <chrono>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/robot/command.h"
#include "core/robot/measurement.h"
#include "core/terrain/bins.h"
#include "core/wire/telemetry.h"

namespace terratact {

/// True heights at the robot's pose.
struct TrueHeights {
    Heights middle{};                ///< means of both sides
    std::array<Heights, 2> sides{};  ///< left, right
};

/// A measurement, and the true terrain, which only a simulation has.
struct Sample {
    Measurement measurement;
    std::optional<Heights> truth;                       ///< means of both sides
    std::optional<std::array<Heights, 2>> sideTruth{};  ///< left, right
    ElementForces forces{};  ///< of the same line; not carried if the source is no bus
};

/// Source of measurements in time order that may accept commands: a robot on a bus, a replayed log
/// or the simulator. next() and send() may be called from different threads.
class MeasurementSource {
public:
    virtual ~MeasurementSource() = default;

    /// Returns the name that the operator reads in the corner: "SIMULATED ROBOT", "can0", "REPLAY
    /// demo.log".
    virtual std::string name() const = 0;

    /// Returns the next sample; empty if none came within `patience`.
    virtual Result<std::optional<Sample>> next(std::chrono::milliseconds patience) = 0;

    /// Sends a command. An Error gives the reason why it could not be sent; Measurement::refusal
    /// reports a refusal by the robot.
    virtual Status send(const Command& command) = 0;
};

}  // namespace terratact
