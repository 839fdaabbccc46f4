#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"
#include "drivers/can_bus.h"
#include "drivers/posix_fd.h"

namespace terratact {

/// One raw CAN socket: system calls without policy, so that SocketCan can be tested on a kernel
/// without CAN. The code of an Error is errno.
class CanSocket {
public:
    enum class Link : std::uint8_t { Up, Down, Gone };
    struct Reading {
        std::size_t frames = 0;
        std::size_t malformed = 0;  ///< datagrams that were no frames
        bool emptied = false;       ///< nothing was left to read
    };

    virtual ~CanSocket() = default;

    /// Waits at most `patience` [s] for the first frame; returns none after a signal. Fills a
    /// BusFrame except its time; wallTime is 0 without a kernel stamp.
    virtual Result<Reading> read(std::span<BusFrame> frames, double patience) = 0;

    /// Never waits.
    virtual Status write(const CanFrame& frame) = 0;

    /// State of the interface that this socket is bound to; another one of the same name does not
    /// count.
    virtual Link link() const = 0;

    virtual std::uint64_t drops() const = 0;        ///< frames dropped so far
    virtual std::size_t receiveBuffer() const = 0;  ///< granted size [B]
};

/// Opens a socket on the interface that receives data, errors, FD frames and its own sent frames.
/// receiveBuffer: [B]; the kernel grants up to twice as much. The Error's code is ENODEV if there
/// is no such interface; any other Error is permanent.
Result<std::unique_ptr<CanSocket>> openCanSocket(const std::string& interface, int receiveBuffer);

/// Uses an existing socket: a test's socketpair, which carries what the kernel would.
std::unique_ptr<CanSocket> canSocketOn(PosixFd fd, const std::string& interface);

}  // namespace terratact
