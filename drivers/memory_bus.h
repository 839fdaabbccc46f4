#pragma once

#include <functional>
#include <memory>
#include <string>

#include "drivers/can_bus.h"

namespace terratact {

/// A bus within this program, without a kernel: what one end sends, all others receive in the same order, and
/// the sender as its echo.  Its ends may be used from any threads and may outlive it.
class MemoryBus {
public:
    using Clock = std::function<double()>;  ///< [s] steady; called from any thread

    /// clock: of the frames' times.
    explicit MemoryBus(Clock clock);
    ~MemoryBus();
    MemoryBus(const MemoryBus&) = delete;
    MemoryBus& operator=(const MemoryBus&) = delete;

    /// Another end.  window: how many frames may be unconfirmed, as SocketCan has it; 0 = any number.  An end
    /// keeps what it has not been asked for, so it wants to be read.
    std::unique_ptr<CanBus> join(const std::string& name, std::size_t window = 2);

    /// Of one end, or of all.  Stalled: what an end sends is kept, and leaves, late as it is, when it is Up
    /// again.  Down and Absent lose what was kept, and neither send nor receive.  Throws
    /// std::invalid_argument where no end has that name.
    void setState(BusState state, const std::string& end = {});

    /// The next frames find no room at any receiver, which count them.
    void dropNext(std::size_t frames);

    /// A frame of somebody else: of another process here where `local`, else of another node.
    void put(const CanFrame& frame, bool local = false);

private:
    struct Socket;
    struct Wire;
    class End;

    std::shared_ptr<Wire> wire_;
};

}  // namespace terratact
