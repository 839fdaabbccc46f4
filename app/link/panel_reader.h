#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "drivers/measurement_source.h"
#include "drivers/operator_panel.h"

namespace terratact {

/// Reads the operator's panel in its own thread.  A STOP that opens there leaves as a command from that very
/// thread, whatever window and estimator are doing; all else waits to be asked for.
class PanelReader {
public:
    /// The source must outlive it.
    PanelReader(std::unique_ptr<OperatorPanel> panel, MeasurementSource& source);

    PanelReport latest() const;

    /// How often each button was pressed since the last call.
    PerContact<int> takePresses();

    /// Likewise, since the start.
    PerContact<std::uint64_t> allPresses() const;

    /// [s] since the panel was last read, by `now` of the steady clock; the panel need not be there.
    double age(double now) const;

    /// What the panel shows from now on.
    void setLamps(const LampState& lamps);

    /// From the kernel's stamp of an edge of STOP to the return of send() [s], of every STOP that left, the
    /// newest thousand.
    std::vector<double> stopLatencies() const;

private:
    void read(const std::stop_token& stop);
    PanelReport poll(const LampState& lamps);
    void take(const PanelReport& report);
    void stopRobot(const PanelReport& report);

    std::unique_ptr<OperatorPanel> panel_;
    MeasurementSource& source_;
    mutable std::mutex mutex_;  // guards what follows
    PanelReport latest_;
    PerContact<int> presses_;
    PerContact<std::uint64_t> allPresses_;
    LampState lamps_;
    double readAt_ = 0.0;
    std::vector<double> latencies_;
    std::jthread thread_;  // last: it starts when all else stands
};

}  // namespace terratact
