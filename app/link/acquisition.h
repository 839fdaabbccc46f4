#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/runtime/steady_now.h"
#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor_watch.h"
#include "drivers/measurement_source.h"

namespace terratact {

using SteadyTime = std::chrono::steady_clock::time_point;

/// The line of telemetry with which the robot said that its flippers are pressed.
struct Press {
    Sample sample;
    std::uint64_t count = 0;  ///< of that line
};

/// When a line of telemetry came.
struct Arrival {
    SteadyTime steady{};
    double sleepless = 0.0;  ///< [s], see sleeplessNow()
};

/// The newest telemetry.
struct Received {
    Sample sample;
    SteadyTime arrived;
    double arrivedSleepless = 0.0;  ///< [s], see sleeplessNow()
    std::uint64_t count = 0;        ///< 1 for the first
    /// Count of the first since the last silence of more than kMaxSilence; a computer that slept has heard nothing.
    std::uint64_t unbrokenFrom = 1;
    std::vector<SensorSuspicion> suspicions{};  ///< of sensors, at that line
    std::optional<Press> press{};  ///< how the present press began; the arm may probe during one
};

/// The newest telemetry after one more line: no line is missed in press, however seldom somebody looks.
Received received(const std::optional<Received>& before, Sample sample, const Arrival& arrived);

/// Reads a source in its own thread into a mailbox that keeps only the newest: whoever draws looks when
/// it likes and can never be flooded.  The source must outlive it.
class Acquisition {
public:
    /// heard: called by that thread when there is a new latest(); empty: nobody is told.
    /// robot: whose sensors are watched (SensorWatch), every line; empty: none are.
    explicit Acquisition(MeasurementSource& source, std::function<void()> heard = {},
                         const std::optional<RobotModel>& robot = {});

    std::optional<Received> latest() const;
    double rate() const;  ///< [Hz] over the last second
    /// What the source complained about last; empty once telemetry comes again.
    std::string trouble() const;

private:
    void read(const std::stop_token& stop);
    void take(const Sample& sample);

    MeasurementSource& source_;
    std::function<void()> heard_;
    std::optional<SensorWatch> sensors_;  // of the thread alone
    mutable std::mutex mutex_;            // guards what follows
    std::optional<Received> latest_;
    std::deque<SteadyTime> arrivals_;
    std::string trouble_;
    std::jthread thread_;  // last: it starts when all else stands
};

}  // namespace terratact
