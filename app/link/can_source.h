#pragma once

#include <array>
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/link/frame_history.h"
#include "app/runtime/steady_now.h"
#include "core/atem/console_link.h"
#include "core/base/message.h"
#include "drivers/can_bus.h"
#include "drivers/measurement_source.h"

namespace terratact {

/// Snapshot of bus and link for the console.
struct CanView {
    LinkView link{};
    BusState bus = BusState::Up;
    std::string busName{};
    BusCounters frames{};
    TelemetryCounters telemetry{};
    ElementForces forces{};  ///< of the newest complete sensor line, even without a measurement
    bool transmits = false;
    std::optional<Message> whyNotTransmitting{};  ///< empty: the source transmits
    bool waits = false;                           ///< a replay that has not begun
    bool ended = false;                           ///< a replay at its end
};

/// Bit rate used for the bus load.
struct BitRate {
    std::optional<double> bitsPerSecond{};  ///< empty: unknown
    bool nominal = false;                   ///< assumed: the bus itself has no bit rate
};

/// A robot on a CAN bus. The thread that calls next() is that of Acquisition (acquisition.h). It receives, sends
/// heartbeats and repeats drive commands. If the console's threads stall, the heartbeats end and the robot's watchdog
/// halts it.
class CanSource final : public MeasurementSource {
public:
    enum class Mode : std::uint8_t { Listen, Transmit, Replay };
    struct Options {
        Mode mode = Mode::Listen;
        std::string name{};  ///< name for the operator; empty: the bus's own name
        ConsoleLink::Options link{};
        /// Returns the true terrain at the robot's pose for every measurement. Empty if the truth is unknown, as with
        /// every real robot.
        std::function<TrueHeights()> truth{};
        bool waits = false;               ///< a replay: next() returns nothing before begin()
        std::optional<double> bitrate{};  ///< [bit/s] for the load; empty: unknown
        bool nominal = false;             ///< the bit rate is assumed, see BitRate
        /// Called with every received frame in the thread of next(), before the link decodes it; empty: no callback.
        std::function<void(std::span<const BusFrame>)> received{};
        /// Monotonic clock of the link [s], the same as that of the bus; any thread calls it.
        std::function<double()> clock = steadyNow;
    };
    CanSource(std::unique_ptr<CanBus> bus, const RobotModel& robot, const Options& options);

    std::string name() const override;
    Result<std::optional<Sample>> next(std::chrono::milliseconds patience) override;

    /// Sends in the calling thread, at once. next() retries Stop, Halt, other safe commands and disarming until they
    /// are sent. A pending Stop is replaced only by its release; other commands are not retried.
    Status send(const Command& command) override;

    void begin() { waits_ = false; }  ///< from any thread

    // Calls of the GUI thread, see ConsoleLink.
    void operatorAlive();
    void wantArming();
    void confirmArming();
    void disarm();
    void approve(const ProbeCommand& probe);

    CanView view() const;
    /// Returns why no command can be sent, whatever its kind; empty: commands are sent.
    std::optional<Message> whyNotTransmitting() const;
    BusState busState() const { return bus_->state(); }
    /// Returns the history of all decoded frames, for the pages that show the bus.
    FrameHistory& tap() { return tap_; }
    BitRate bitrate() const { return {options_.bitrate, options_.nominal}; }
    Mode mode() const { return options_.mode; }
    std::string busName() const { return bus_->name(); }
    /// Received frames that still wait for decoding, measured when new frames arrive.
    struct Waiting {
        std::size_t now = 0, most = 0;
    };
    Waiting waiting() const { return {waiting_, mostWaiting_}; }

private:
    bool ended() const;
    std::optional<Message> trouble() const;
    std::optional<Sample> consumePending();
    void work();
    void remember(const Command& command, bool left);

    std::unique_ptr<CanBus> bus_;
    Options options_;
    std::array<BusFrame, 64> frames_;
    std::deque<BusFrame> pending_;  // used by next() only, with frames_
    std::atomic<bool> waits_;
    FrameHistory tap_;
    std::atomic<std::size_t> waiting_ = 0, mostWaiting_ = 0;

    mutable std::mutex mutex_;  // guards the members below
    ConsoleLink link_;
    std::optional<Command> unsent_;  ///< the safest command that is not sent yet
};

/// A precondition of arming about the link.
struct LinkNeed {
    bool met = false;
    Message text;  ///< text of the condition: met, or the reason why not
};
std::vector<LinkNeed> armingNeeds(const CanView& view);

/// Returns why the operator cannot arm now: the first unmet need. Empty: arming is possible.
std::optional<Message> whyNotArming(const CanView& view);

}  // namespace terratact
