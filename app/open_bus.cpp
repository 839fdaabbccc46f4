#include "app/open_bus.h"

#include "drivers/candump_replay.h"
#include "drivers/socketcan.h"

namespace terratact {

Result<std::unique_ptr<CanBus>> openBus(const std::string& interface)
{
    Result<std::unique_ptr<SocketCan>> bus = SocketCan::open({.interface = interface});
    if (!bus) return bus.error();
    return std::unique_ptr<CanBus>(*std::move(bus));
}

Result<std::unique_ptr<CanBus>> openReplay(const std::string& path, const std::string& interface,
                                           double speed)
{
    Result<std::unique_ptr<CandumpReplay>> replay =
        CandumpReplay::open(path, {.interface = interface, .speed = speed});
    if (!replay) return replay.error();
    return std::unique_ptr<CanBus>(*std::move(replay));
}

}  // namespace terratact
