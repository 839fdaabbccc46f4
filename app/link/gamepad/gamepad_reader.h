#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "app/link/gamepad/pad_intents.h"
#include "app/runtime/steady_now.h"
#include "drivers/measurement_source.h"

namespace terratact {

/// Reads the gamepad in its own thread. This thread itself sends STOP when a button of STOP is pressed, independent of
/// the window. Clients poll everything else.
class GamepadReader {
public:
    static constexpr std::chrono::milliseconds kPeriod{5};
    static constexpr double kFreshFor = 0.1;  ///< [s] an older state is no gamepad

    using Clock = std::function<double()>;  ///< monotonic clock [s]

    /// The source must outlive the reader.
    GamepadReader(std::unique_ptr<Gamepad> gamepad, MeasurementSource& source,
                  Clock clock = steadyNow);

    /// Returns the newest state. A state that is older than kFreshFor at `now` [s], of that clock, is returned as a
    /// lost gamepad.
    GamepadState latest(double now) const;

    /// Sets the buttons of STOP, and whether this console may send it.
    void setStop(const PadMapping& mapping, bool sends);

    /// Returns how often STOP was pressed since the last call.
    int consumeStops();

private:
    void read(const std::stop_token& stop);
    GamepadState poll();

    std::unique_ptr<Gamepad> gamepad_;
    MeasurementSource& source_;
    Clock clock_;
    mutable std::mutex mutex_;  // guards the members below
    GamepadState latest_;
    double readAt_ = 0.0;
    PadSettings settings_;
    bool sends_ = false;
    int stops_ = 0;
    std::jthread thread_;  // last member: the thread starts after all others exist
};

}  // namespace terratact
