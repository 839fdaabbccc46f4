#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/robot/watch/ground_watch.h"
#include "core/robot/watch/pitch_sign_watch.h"
#include "core/robot/watch/press_watch.h"
#include "core/robot/watch/return_watch.h"
#include "core/robot/watch/sensor.h"
#include "core/robot/watch/sensor_suspicion.h"
#include "core/robot/watch/side_watch.h"
#include "core/robot/watch/spike_watch.h"
#include "core/robot/watch/stuck_watch.h"
#include "core/robot/watch/unloaded_watch.h"

namespace terratact {

/// Detects faulty sensors in lines of telemetry at any rate. It has no clock: times are those of
/// the lines. A time that goes back, or a silence longer than kMaxSilence, restarts the rules but
/// keeps the suspicions. Memory is bounded. core/README.md, "Sensor faults", lists rules and
/// limits.
class SensorWatch {
public:
    explicit SensorWatch(const RobotModel& robot);

    /// Adds the next line. Judges each side of a force element that is known, else the mean. Throws
    /// std::invalid_argument unless the time is finite.
    void add(const Measurement& line);

    /// Returns the suspicions at the time of the last line, at most one per sensor and fault, in
    /// that order.
    const std::vector<SensorSuspicion>& standing() const { return standing_; }

    void reset();

private:
    void note(const SensorSuspicion& found);
    void forgetCleared();
    void forgetOld(double now);
    void preferSides();

    StuckWatch stuck_;
    SpikeWatch spikes_;
    PressWatch presses_;
    PitchSignWatch pitchSign_;
    UnloadedWatch unloaded_;
    SideWatch sides_;
    GroundWatch ground_;
    ReturnWatch return_;
    std::optional<double> last_;
    std::vector<SensorSuspicion> standing_;
};

}  // namespace terratact
