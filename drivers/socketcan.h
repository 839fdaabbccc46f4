#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"
#include "core/wire/can_error.h"
#include "drivers/can_bus.h"
#include "drivers/can_socket.h"

namespace terratact {

/// Returns Done for a name of 1 to 15 characters A-Z a-z 0-9 _ . -; other interface names are not
/// accepted.
Status checkInterfaceName(std::string_view name);

/// CAN interface of Linux. An interface that goes down, or disappears and comes back, is found
/// again by its name. A present one is checked every 0.1 s. An absent one is looked for after 0.1
/// s, and later after up to 1 s. Frames to be sent meanwhile are refused, never sent later.
///
/// The kernel sends every accepted frame, however late. If no node acknowledges, commands would
/// wait and then all leave at once. A window prevents that: send() refuses while `maxUnconfirmed`
/// frames have no echo yet, or the oldest of them for `stalledAfter`. At most that many frames are
/// ever late.
/// Echoes that the kernel had no room for, or that were lost with the controller, are not awaited.
/// If an echo is missing for another reason, the bus stays Stalled until the interface is set down
/// and up.
class SocketCan final : public CanBus {
public:
    struct Options {
        std::string interface = {};
        bool transmit = false;           ///< false: receive-only, send() refuses every frame
        std::size_t maxUnconfirmed = 2;  ///< 0: any number, for bursts of telemetry
        double stalledAfter = 0.06;      ///< [s]
        /// [B]; the kernel doubles it: room for 10,900 frames, 1.2 s of a full bus.
        int receiveBuffer = 4 << 20;
    };

    /// System functions, which tests replace.
    struct System {
        std::function<Result<std::unique_ptr<CanSocket>>()> openSocket;
        std::function<double()> steadyTime;  ///< [s]
        std::function<double()> wallTime;    ///< [s]
        std::function<void(double)> sleep;   ///< [s]
    };

    /// Opens an interface, which may be absent: it is awaited. Error: the name is invalid, the
    /// interface is no CAN interface, or the kernel lacks CAN or forbids it.
    static Result<std::unique_ptr<SocketCan>> open(const Options& options);
    static Result<std::unique_ptr<SocketCan>> open(const Options& options, System system);

    std::string name() const override { return options_.interface; }
    Result<std::size_t> receive(std::span<BusFrame> frames,
                                std::chrono::milliseconds patience) override;
    Status send(const CanFrame& frame) override;
    BusState state() const override;
    BusCounters counters() const override;

    /// Returns a problem of a working bus: a receive buffer that is too small. Empty: none.
    std::string warning() const;

private:
    SocketCan(const Options& options, System system);

    struct Sent {
        CanFrame frame;
        double time;
    };
    /// Times since when, and when last, the kernel's queue was full.
    struct Full {
        double since, last;
    };

    Status connect();
    void poll();
    double untilLook() const;
    void became(BusState link);
    void failed(int code);
    std::size_t unpack(std::span<BusFrame> frames, const CanSocket::Reading& reading);
    void addError(const BusFrame& frame);
    void confirm(const CanFrame& frame);
    std::uint64_t drops() const;
    bool overdue(double now) const;
    BusState stateAt(double now) const;
    std::optional<Message> obstacle(double now) const;

    const Options options_;
    const System system_;

    mutable std::mutex mutex_;  // guards the members below
    std::unique_ptr<CanSocket>
        socket_;  // Only receive() replaces the socket, and reads from it without the mutex.
    BusState link_ = BusState::Absent;  // Up, Down or Absent
    ControllerState controller_ = ControllerState::Active;
    std::deque<Sent> unconfirmed_;
    std::optional<Full> full_;
    BusCounters counters_;
    std::uint64_t earlierDrops_ = 0;  // drops of closed sockets
    std::uint64_t knownDrops_ = 0;
    double emptiedAt_ = 0.0;  // time at which nothing was left to read
    double backOff_;          // [s]
    double nextLook_ = 0.0;   // time of the next check of the interface
};

}  // namespace terratact
