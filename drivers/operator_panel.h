#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/atem/panel.h"
#include "core/atem/panel_file.h"
#include "core/base/result.h"
#include "drivers/gpio_lines.h"

namespace terratact {

/// Returns the lines that a panel file needs. Inputs: the contacts in their order, active while
/// closed.
GpioRequest requestOf(const PanelConfig& panel);

struct PanelCounters {
    PerContact<std::uint64_t> edges;  ///< seen edges of each contact
    std::uint64_t lostEdges = 0;      ///< number of times that the kernel had no room for all edges
    std::uint64_t losses = 0;         ///< number of times that the panel was lost
};

struct PanelReport {
    PanelState state;
    LampState lamps;  ///< as they are lit, if known
    /// Kernel's stamp of STOP's newest edge on the steady clock [s]; 0: none yet.
    double stopEdge = 0.0;
    PanelCounters counters;
    /// One sentence about the worst fault: the panel is absent, a lamp fails, or a button is stuck.
    /// Empty: no fault.
    Message trouble;
};

/// The operator panel on GPIO lines. nextPanel() judges and debounces its contacts
/// (core/atem/panel.h). One thread must call poll() in a loop.
class OperatorPanel {
public:
    using Open = std::function<Result<std::unique_ptr<GpioLines>>(const GpioRequest&)>;
    using Clock = std::function<double()>;  ///< monotonic clock [s]

    static constexpr std::chrono::milliseconds kPeriod{10};  ///< longest time between two readings

    /// Opens nothing yet. `open` is openGpioLines, or a test's function.
    OperatorPanel(PanelConfig panel, Open open);
    OperatorPanel(PanelConfig panel, Open open, Clock clock);

    /// Switches all lamps off.
    ~OperatorPanel();
    OperatorPanel(const OperatorPanel&) = delete;
    OperatorPanel& operator=(const OperatorPanel&) = delete;

    /// Waits for an edge, at most `patience` and kPeriod, and reads the panel. Lights the lamps if
    /// they must change. An absent panel is a state: it is searched every 0.1 s, later every
    /// second. At its first appearance it tests its lamps before it shows `lamps`.
    PanelReport poll(const LampState& lamps, std::chrono::milliseconds patience);

    /// Returns the positions of its lines; empty while it is absent.
    std::optional<GpioFound> found() const;

private:
    void open();
    void poll(std::chrono::milliseconds patience);
    void count(const GpioEdges& edges);
    void lose(const Error& why);
    void light(const LampState& lamps);
    Message trouble() const;

    PanelConfig panel_;
    Open open_;
    Clock clock_;
    std::unique_ptr<GpioLines> lines_;   // null: absent
    std::optional<double> firstOpened_;  // [s]
    double nextOpening_ = 0.0;           // [s]
    double backOff_ = 0.0;               // [s]
    PanelReport report_;
    Message absence_, lampTrouble_;
    bool lit_ = false;  // true if the lines are set to report_.lamps
};

}  // namespace terratact
