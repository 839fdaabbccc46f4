#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "core/wire/can_error.h"
#include "drivers/can_bus.h"
#include "drivers/can_socket.h"

namespace terratact {

/// Done for 1 to 15 of A-Z a-z 0-9 _ . -, which is all that we accept for an interface.
Status checkInterfaceName(std::string_view name);

/// A CAN interface of Linux.  An interface that goes down, or away and comes back, is found again by its name;
/// what was to be sent meanwhile is refused and forgotten, never sent later.
///
/// What the kernel has accepted it sends, however late: with nobody on the bus to acknowledge, commands would
/// wait and then all leave at once.  Hence a window: as long as `maxUnconfirmed` frames have not come back as
/// echoes, or the oldest of them for `stalledAfter`, send() refuses.  So at most that many are ever late.
/// An echo that the kernel had no room for, or that died with the controller, is not waited for; if one fails
/// to come for any other reason, the bus stays Stalled until the interface is set down and up again.
class SocketCan final : public CanBus {
public:
    struct Options {
        std::string interface = {};
        bool transmit = false;           ///< else receive-only: send() refuses everything
        std::size_t maxUnconfirmed = 2;  ///< 0: any number, for bursts of telemetry
        double stalledAfter = 0.06;      ///< [s]
        /// [B]; the kernel doubles it: room for 10,900 frames, 1.2 s of a full bus.
        int receiveBuffer = 4 << 20;
    };

    /// What it stands on, for tests to replace.
    struct System {
        std::function<Result<std::unique_ptr<CanSocket>>()> openSocket;
        std::function<double()> steadyTime;  ///< [s]
        std::function<double()> wallTime;    ///< [s]
        std::function<void(double)> sleep;   ///< [s]
    };

    /// Absent is fine: it is waited for.  An Error: the name is none, the interface is no CAN interface, or
    /// the kernel has no CAN or forbids it.
    static Result<std::unique_ptr<SocketCan>> open(const Options& options);
    static Result<std::unique_ptr<SocketCan>> open(const Options& options, System system);

    std::string name() const override { return options_.interface; }
    Result<std::size_t> receive(std::span<BusFrame> frames,
                                std::chrono::milliseconds patience) override;
    Status send(const CanFrame& frame) override;
    BusState state() const override;
    BusCounters counters() const override;

    /// What is not as it should be, though it works: a receive buffer too small.  Empty: nothing.
    std::string warning() const;

private:
    SocketCan(const Options& options, System system);

    struct Sent {
        CanFrame frame;
        double time;
    };
    /// Since when, and when last, the kernel's queue had no room.
    struct Full {
        double since, last;
    };

    Status connect();
    void poll();
    double untilLook() const;
    void became(BusState link);
    void failed(int code);
    std::size_t take(std::span<BusFrame> frames, const CanSocket::Reading& reading);
    void takeError(const BusFrame& frame);
    void confirm(const CanFrame& frame);
    std::uint64_t drops() const;
    bool overdue(double now) const;
    BusState stateAt(double now) const;
    std::string obstacle(double now) const;

    const Options options_;
    const System system_;

    mutable std::mutex mutex_;  // guards all that follows
    std::unique_ptr<CanSocket>
        socket_;  // only receive() replaces it, and reads from it without the mutex
    BusState link_ = BusState::Absent;  // Up, Down or Absent
    ControllerState controller_ = ControllerState::Active;
    std::deque<Sent> unconfirmed_;
    std::optional<Full> full_;
    BusCounters counters_;
    std::uint64_t earlierDrops_ = 0;  // of sockets closed
    std::uint64_t knownDrops_ = 0;
    double emptiedAt_ = 0.0;  // when nothing was left to read
    double backOff_;          // [s]
    double nextLook_ = 0.0;   // at the interface
};

}  // namespace terratact
