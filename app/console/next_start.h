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

/// Returns the next start after a failed one, so that a console in use is not lost. First it is the former connection.
/// If that fails, it is the simulated robot without an operator panel. Empty: the first start failed, or the simulated
/// robot. former: connection before the operator chose another one. trouble: why the other one failed, if `failed` is
/// the former one. reason: why `failed` failed.
std::optional<NextStart> startAfter(const ConsoleOptions& failed,
                                    const std::optional<ConsoleOptions>& former,
                                    const std::optional<Message>& trouble, const Message& reason);

}  // namespace terratact
