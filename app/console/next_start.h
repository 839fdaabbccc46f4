#pragma once

#include <optional>

#include "app/start/console_options.h"
#include "core/base/message.h"

namespace terratact {

struct ConnectionWish;

/// A start of the console, and what its operator must know about it.
struct NextStart {
    ConsoleOptions options;
    Message why;
};

/// Returns the options of a start with another robot.
ConsoleOptions connectedTo(ConsoleOptions options, const ConnectionWish& wish);

/// Returns how to go on after a start failed, so that a console in use is not lost: with the former connection; if that
/// failed, with the simulated robot, without an operator panel. Empty: this was the first start, or the last way.
/// former: connection before the operator asked for another; trouble: why that other was not connected, once `failed`
/// is the former; reason: of this failure.
std::optional<NextStart> startAfter(const ConsoleOptions& failed,
                                    const std::optional<ConsoleOptions>& former,
                                    const std::optional<Message>& trouble, const Message& reason);

}  // namespace terratact
