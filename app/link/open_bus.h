#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "drivers/can_bus.h"
#include "drivers/log_replay.h"

namespace terratact {

/// Opens a CAN interface of this computer for listening.
Result<std::unique_ptr<CanBus>> openBus(const std::string& interface);

/// Opens a CAN log as a bus, see LogReplay. interface: empty if the log has only one.
Result<std::unique_ptr<LogReplay>> openReplay(const std::string& path, const std::string& interface,
                                              double speed);

}  // namespace terratact
