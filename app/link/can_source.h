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
#include "core/atem/console_link.h"
#include "drivers/can_bus.h"
#include "drivers/measurement_source.h"

namespace terratact {

/// What a console shows of bus and link together.
struct CanView {
    LinkView link;
    BusState bus = BusState::Up;
    BusCounters frames;
    TelemetryCounters telemetry;
    std::optional<SensorLine> line;  ///< the newest whole one
    ElementForces forces;            ///< of that line
    bool transmits = false;
    std::string whyNotTransmitting;  ///< in words; empty where it transmits
    bool waits = false;              ///< a replay that has not begun
    bool ended = false;              ///< a replay that has come to its end
};

/// What the load of a bus is told of.
struct BitRate {
    std::optional<double> bitsPerSecond{};  ///< empty: not known
    bool nominal = false;                   ///< nobody has set it or counts by it
};

/// A robot on a CAN bus.  The thread that calls next() receives, beats the heart and repeats drives, so
/// that a console whose threads stand still falls silent and its robot halts.
class CanSource final : public MeasurementSource {
public:
    enum class Mode : std::uint8_t { Listen, Transmit, Replay };
    struct Options {
        Mode mode = Mode::Listen;
        std::string name{};  ///< what the operator reads; the bus's own where it is empty
        ConsoleLink::Options link{};
        /// The true terrain at the robot's pose, asked for with every measurement; empty where nobody knows it,
        /// as of every real robot.
        std::function<Heights()> truth{};
        bool waits = false;  ///< next() brings nothing before begin(): a replay for its viewer
        std::optional<double> bitrate{};  ///< [bit/s] for the load; empty: not known
        bool nominal = false;  ///< the bus counts no bits; it is what a real one would have
        /// Hears every frame in the thread that calls next(), before it means anything; empty: nobody.
        std::function<void(std::span<const BusFrame>)> heard{};
    };
    CanSource(std::unique_ptr<CanBus> bus, const RobotModel& robot, const Options& options);

    std::string name() const override;
    Result<std::optional<Sample>> next(std::chrono::milliseconds patience) override;

    /// Leaves in the calling thread, at once.  Stop, Halt and the like, and disarming, are tried again in next()
    /// until they have left, a stop whatever is said after it but its release; nothing else is.
    Status send(const Command& command) override;

    void begin() { waits_ = false; }  ///< from any thread

    // From the GUI thread, see ConsoleLink.
    void operatorAlive();
    void wantArming();
    void confirmArming();
    void disarm();
    void approve(int bin);

    CanView view() const;
    /// Everything that was received, for the pages that show the bus itself.
    FrameHistory& tap() { return tap_; }
    BitRate bitrate() const { return {options_.bitrate, options_.nominal}; }
    Mode mode() const { return options_.mode; }
    std::string busName() const { return bus_->name(); }
    /// Frames that were received and not yet looked at, when new ones came.
    struct Waiting {
        std::size_t now = 0, most = 0;
    };
    Waiting waiting() const { return {waiting_, mostWaiting_}; }

private:
    std::string whyNotTransmitting() const;
    bool ended() const;
    std::string trouble() const;
    std::optional<Sample> takePending();
    void work();
    void remember(const Command& command, bool left);

    std::unique_ptr<CanBus> bus_;
    Options options_;
    std::array<BusFrame, 64> frames_;
    std::deque<BusFrame> pending_;  // only next() touches these two
    std::atomic<bool> waits_;
    FrameHistory tap_;
    std::atomic<std::size_t> waiting_ = 0, mostWaiting_ = 0;

    mutable std::mutex mutex_;  // guards what follows
    ConsoleLink link_;
    std::optional<Command> unsent_;  ///< the safest command that has not left yet
};

/// What arming needs of a link.
struct LinkNeed {
    bool met = false;
    std::string text;  ///< in words: that it is so, or why not
};
std::vector<LinkNeed> armingNeeds(const CanView& view);

/// Why the operator cannot begin to arm now, in words: the first need that is not met; empty where it is possible.
std::string whyNotArming(const CanView& view);

}  // namespace terratact
