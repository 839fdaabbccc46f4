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

/// The lines that a panel's file asks for.  Inputs: the contacts in their order, active while closed.
GpioRequest requestOf(const PanelConfig& panel);

struct PanelCounters {
    PerContact<std::uint64_t> edges;  ///< seen of each contact
    std::uint64_t lostEdges = 0;      ///< times the kernel had no room for all
    std::uint64_t losses = 0;         ///< times the panel was there and went
};

struct PanelReport {
    PanelState state;
    LampState lamps;  ///< as they are lit, as far as known
    /// [s] steady clock, the kernel's stamp of STOP's newest edge; 0: none yet
    double stopEdge = 0.0;
    PanelCounters counters;
    /// Why the panel is absent, which lamp does not obey, which button is stuck: the gravest of these in
    /// one sentence; empty where all is well.
    std::string trouble;
};

/// The operator's panel on GPIO lines.  For one thread that calls poll() in a loop.
class OperatorPanel {
public:
    using Open = std::function<Result<std::unique_ptr<GpioLines>>(const GpioRequest&)>;
    using Clock = std::function<double()>;  ///< [s] monotonic

    static constexpr std::chrono::milliseconds kPeriod{10};  ///< between two looks, at most

    /// Opens nothing yet.  `open` is openGpioLines, or a test's.
    OperatorPanel(PanelConfig panel, Open open);
    OperatorPanel(PanelConfig panel, Open open, Clock clock);

    /// All lamps go dark.
    ~OperatorPanel();
    OperatorPanel(const OperatorPanel&) = delete;
    OperatorPanel& operator=(const OperatorPanel&) = delete;

    /// Waits for an edge, at most `patience` and kPeriod, and looks at the panel; lights the lamps where
    /// they are to change.  A panel that is not there is a state: it is looked for again every 0.1 s, later
    /// every second.  Where it comes up for the first time, it tests its lamps before it shows `lamps`.
    PanelReport poll(const LampState& lamps, std::chrono::milliseconds patience);

    /// Where its lines are; nothing while it is absent.
    std::optional<GpioFound> found() const;

private:
    void open();
    void poll(std::chrono::milliseconds patience);
    void count(const GpioEdges& edges);
    void lose(const Error& why);
    void light(const LampState& lamps);
    std::string trouble() const;

    PanelConfig panel_;
    Open open_;
    Clock clock_;
    std::unique_ptr<GpioLines> lines_;   // null: absent
    std::optional<double> firstOpened_;  // [s]
    double nextOpening_ = 0.0;           // [s]
    double backOff_ = 0.0;               // [s]
    PanelReport report_;
    std::string absence_, lampTrouble_;  // sentences
    bool lit_ = false;                   // report_.lamps is what the lines are set to
};

}  // namespace terratact
