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

/// One raw CAN socket: system calls and no policy, so that SocketCan can be tested without a kernel that
/// knows CAN.  An Error has the errno.
class CanSocket {
public:
    enum class Link : std::uint8_t { Up, Down, Gone };
    struct Reading {
        std::size_t frames = 0;
        std::size_t malformed = 0;  ///< datagrams that were no frames
        bool emptied = false;       ///< nothing was left to read
    };

    virtual ~CanSocket() = default;

    /// Waits at most `patience` [s] for the first frame; nothing at all after a signal.  Fills all of a
    /// BusFrame but its time; wallTime is 0 where the kernel gave no stamp.
    virtual Result<Reading> read(std::span<BusFrame> frames, double patience) = 0;

    /// Never waits.
    virtual Status write(const CanFrame& frame) = 0;

    /// Of the interface that this socket is bound to; another of the same name does not count.
    virtual Link link() const = 0;

    virtual std::uint64_t drops() const = 0;        ///< frames that found no room, up to now
    virtual std::size_t receiveBuffer() const = 0;  ///< [B] as granted
};

/// Bound to the interface, with everything that it receives: data, errors, FD and own frames that left.
/// receiveBuffer: [B], of which the kernel grants twice as much or less.  The Error's code is ENODEV where
/// there is no such interface; every other one will not mend itself.
Result<std::unique_ptr<CanSocket>> openCanSocket(const std::string& interface, int receiveBuffer);

/// On a socket that is there; a test's socketpair, which carries what the kernel would.
std::unique_ptr<CanSocket> canSocketOn(PosixFd fd, const std::string& interface);

}  // namespace terratact
