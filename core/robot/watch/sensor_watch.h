#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/robot/robot_model.h"
#include "core/robot/watch/ground_watch.h"
#include "core/robot/watch/pitch_sign_watch.h"
#include "core/robot/watch/press_watch.h"
#include "core/robot/watch/return_watch.h"
#include "core/robot/watch/sensor.h"
#include "core/robot/watch/sensor_suspicion.h"
#include "core/robot/watch/spike_watch.h"
#include "core/robot/watch/stuck_watch.h"
#include "core/robot/watch/unloaded_watch.h"

namespace terratact {

/// Looks for sensors that lie, in lines of telemetry at any rate.  No clock: times are those of the lines; a time
/// that goes back, or a silence of more than kMaxSilence, begins anew but for what already is suspected.
/// Memory is bounded.  Rules and limits: core/README.md, "Sensors that lie".
class SensorWatch {
public:
    explicit SensorWatch(const RobotModel& robot);

    /// The next line.  Throws std::invalid_argument unless its time is finite.
    void take(const Measurement& line);

    /// What stands at the time of the last line, at most one of each sensor and trouble, in that order.
    const std::vector<SensorSuspicion>& standing() const { return standing_; }

    void reset();

private:
    void note(const SensorSuspicion& found);
    void forgetCleared();
    void forgetOld(double now);

    StuckWatch stuck_;
    SpikeWatch spikes_;
    PressWatch presses_;
    PitchSignWatch pitchSign_;
    UnloadedWatch unloaded_;
    GroundWatch ground_;
    ReturnWatch return_;
    std::optional<double> last_;
    std::vector<SensorSuspicion> standing_;
};

}  // namespace terratact
