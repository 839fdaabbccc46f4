#include "app/console/next_start.h"

#include <utility>

#include "app/console/connection/connect_window.h"

namespace terratact {

ConsoleOptions connectedTo(ConsoleOptions options, const ConnectionWish& wish)
{
    options.can = wish.can;
    options.transmit = wish.transmit;
    options.replay.clear();
    options.interface.clear();
    return options;
}

std::optional<NextStart> startAfter(const ConsoleOptions& failed,
                                    const std::optional<ConsoleOptions>& former,
                                    const std::optional<Message>& trouble, const Message& reason)
{
    if (former)
        return NextStart{*former, Message(TR_NOOP("OpenConsole", "not connected: %1"), reason)};
    const bool isLast = failed.can.empty() && failed.replay.empty() && failed.panel.empty();
    if (!trouble || isLast) return std::nullopt;
    NextStart next{
        connectedTo(failed, {}),
        Message(TR_NOOP("OpenConsole", "%1. The former connection failed, too: %2. This is the "
                                       "simulated robot"),
                *trouble, reason)};
    next.options.panel.clear();
    return next;
}

}  // namespace terratact
