#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "drivers/measurement_source.h"
#include "drivers/operator_panel.h"

namespace terratact {

/// Reads the operator's panel in its own thread. This thread itself sends STOP when the STOP circuit opens, or the
/// panel is lost, independent of window and estimator. Clients poll everything else.
class PanelReader {
public:
    /// The source must outlive the reader.
    PanelReader(std::unique_ptr<OperatorPanel> panel, MeasurementSource& source);

    PanelReport latest() const;

    /// Returns how often each button was pressed since the last call.
    PerContact<int> consumePresses();

    /// Returns how often each button was pressed since the start.
    PerContact<std::uint64_t> allPresses() const;

    /// Returns the time [s] between the last read attempt and `now` on the steady clock, with or without a panel.
    double age(double now) const;

    /// Sets the panel's lamps.
    void setLamps(const LampState& lamps);

    /// Returns the latency [s] of each STOP that was sent. It lasts from the kernel's time stamp of the edge to the
    /// return of send(). Only the newest thousand are kept.
    std::vector<double> stopLatencies() const;

private:
    void read(const std::stop_token& stop);
    PanelReport poll(const LampState& lamps);
    void add(const PanelReport& report);
    void stopRobot(const PanelReport& report);

    std::unique_ptr<OperatorPanel> panel_;
    MeasurementSource& source_;
    mutable std::mutex mutex_;  // guards the members below
    PanelReport latest_;
    PerContact<int> presses_;
    PerContact<std::uint64_t> allPresses_;
    LampState lamps_;
    double readAt_ = 0.0;
    std::vector<double> latencies_;
    std::jthread thread_;  // last member: the thread starts after all others exist
};

}  // namespace terratact
