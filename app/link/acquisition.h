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
#include "core/base/message.h"
#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor_watch.h"
#include "drivers/measurement_source.h"

namespace terratact {

using SteadyTime = std::chrono::steady_clock::time_point;

/// The first sample in which the robot reported that its flippers are pressed.
struct Press {
    Sample sample;
    std::uint64_t count = 0;  ///< count of that sample
};

/// Arrival time of a sample.
struct Arrival {
    SteadyTime steady{};
    double sleepless = 0.0;  ///< [s], see sleeplessNow()
};

/// The newest telemetry.
struct Received {
    Sample sample;
    SteadyTime arrived;
    double arrivedSleepless = 0.0;  ///< [s], see sleeplessNow()
    std::uint64_t count = 0;        ///< 1 for the first sample
    /// Count of the first sample after the last silence of more than kMaxSilence. Suspend counts as silence.
    std::uint64_t unbrokenFrom = 1;
    std::vector<SensorSuspicion> suspicions{};  ///< suspicions of SensorWatch at that sample
    std::optional<Press> press{};  ///< start of the present press; the arm may probe during one
};

/// Returns `before` updated with one more sample. Every sample updates press, however rarely a client polls.
Received received(const std::optional<Received>& before, Sample sample, const Arrival& arrived);

/// Reads a source in its own thread into a mailbox that keeps only the newest sample. A client polls at its own rate
/// and is never flooded. The console's client is MainWindow::poll(). The source must outlive the Acquisition.
class Acquisition {
public:
    /// received: called by that thread after each new latest(); empty: no callback. robot: its sensors are checked at
    /// every sample (SensorWatch). Empty: no check.
    explicit Acquisition(MeasurementSource& source, std::function<void()> received = {},
                         const std::optional<RobotModel>& robot = {});

    /// Called with every sample, in the reading thread; it must be quick and call nothing of this object.
    using Listener = std::function<void(const Received& sample)>;
    void listen(const Listener& listener);  ///< empty: nothing is called any more

    std::optional<Received> latest() const;
    double rate() const;  ///< [Hz] sample rate over the last second
    /// Returns the source's last error; empty once telemetry arrives again.
    Message trouble() const;

private:
    void read(const std::stop_token& stop);
    void receive(const Sample& sample);

    MeasurementSource& source_;
    std::function<void()> received_;
    std::optional<SensorWatch> sensors_;  // used by the thread only
    mutable std::mutex mutex_;            // guards the members below
    std::optional<Received> latest_;
    std::deque<SteadyTime> arrivals_;
    Message trouble_;
    Listener listener_;
    std::jthread thread_;  // last member: the thread starts after all others exist
};

}  // namespace terratact
