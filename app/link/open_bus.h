#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "drivers/can_bus.h"
#include "drivers/log_replay.h"

namespace terratact {

/// A CAN interface of this computer to listen to.
Result<std::unique_ptr<CanBus>> openBus(const std::string& interface);

/// A log of CAN traffic as a bus, see LogReplay; interface: empty where the log has but one.
Result<std::unique_ptr<LogReplay>> openReplay(const std::string& path, const std::string& interface,
                                              double speed);

}  // namespace terratact
