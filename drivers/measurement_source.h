#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/robot/command.h"
#include "core/robot/measurement.h"
#include "core/terrain/bins.h"

namespace terratact {

/// A measurement, and the true terrain where the source knows it (only a simulation does).
struct Sample {
    Measurement measurement;
    std::optional<Heights> truth;
};

/// A robot on a bus, a replayed log or the simulator: anything that yields measurements in time order
/// and may take commands.  next() and send() may be called from different threads.
class MeasurementSource {
public:
    virtual ~MeasurementSource() = default;

    /// What the operator reads in the corner: "SIMULATED ROBOT", "can0", "REPLAY demo.log".
    virtual std::string name() const = 0;

    /// Waits at most `patience`; an empty optional means nothing came in that time.
    virtual Result<std::optional<Sample>> next(std::chrono::milliseconds patience) = 0;

    /// Passes a command on.  An Error says why it could not be sent; a refusal by the robot comes back
    /// in Measurement::refusal.
    virtual Status send(const Command& command) = 0;
};

}  // namespace terratact
