#pragma once

#include <functional>
#include <memory>
#include <string>

#include "drivers/can_bus.h"

namespace terratact {

/// Bus within this program, without a kernel. All other ends receive a sent frame in the same
/// order, and the sender receives its echo. Any thread may use an end, and an end may outlive the
/// bus.
class MemoryBus {
public:
    using Clock = std::function<double()>;  ///< steady clock [s]; any thread may call it

    /// clock: for the frames' times.
    explicit MemoryBus(Clock clock);
    ~MemoryBus();
    MemoryBus(const MemoryBus&) = delete;
    MemoryBus& operator=(const MemoryBus&) = delete;

    /// Adds an end. window: number of unconfirmed frames, as in SocketCan; 0: any number. An end
    /// keeps frames that were not read, so it must be read.
    std::unique_ptr<CanBus> join(const std::string& name, std::size_t window = 2);

    /// Sets the state of one end, or of all. Stalled: an end's frames are kept, and leave late once
    /// it is Up again. Down and Absent discard kept frames, and neither send nor receive. Throws
    /// std::invalid_argument if no end has that name.
    void setState(BusState state, const std::string& end = {});

    /// Drops the next frames at every receiver; the receivers count them.
    void dropNext(std::size_t frames);

    /// Puts a frame on the bus: from a process of this computer if `local`, else from another node.
    void put(const CanFrame& frame, bool local = false);

private:
    struct Socket;
    struct Wire;
    class End;

    std::shared_ptr<Wire> wire_;
};

}  // namespace terratact
