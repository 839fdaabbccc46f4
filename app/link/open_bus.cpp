#include "app/link/open_bus.h"

#include "drivers/socketcan.h"

namespace terratact {

Result<std::unique_ptr<CanBus>> openBus(const std::string& interface)
{
    Result<std::unique_ptr<SocketCan>> bus = SocketCan::open({.interface = interface});
    if (!bus) return bus.error();
    return std::unique_ptr<CanBus>(*std::move(bus));
}

Result<std::unique_ptr<LogReplay>> openReplay(const std::string& path, const std::string& interface,
                                              double speed)
{
    return LogReplay::open(path, {.interface = interface, .speed = speed});
}

}  // namespace terratact
