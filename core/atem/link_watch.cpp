#include "core/atem/link_watch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/message.h"

namespace terratact {

SourceText describe(const LinkAccount& link)
{
    switch (link.standing) {
    case LinkStanding::Silent: return TR_NOOP("core", "no telemetry yet");
    case LinkStanding::Up: return TR_NOOP("core", "link is up");
    case LinkStanding::Lost:
        return link.alone ? TR_NOOP("core", "telemetry lost") : TR_NOOP("core", "link lost");
    case LinkStanding::Unsteady:
        return link.alone ? TR_NOOP("core", "telemetry unsteady")
                          : TR_NOOP("core", "link unsteady");
    case LinkStanding::Ended: return TR_NOOP("core", "end of the log");
    }
    throw std::invalid_argument("describe: no such LinkStanding");
}

const LinkAccount& LinkWatch::poll(const LinkGlimpse& seen)
{
    if (!std::isfinite(seen.now) || !std::isfinite(seen.age.value_or(0.0)))
        throw std::invalid_argument("LinkWatch: the times must be finite");
    if (seen.ended)
        account_ = {.standing = LinkStanding::Ended};
    else if (!seen.age)
        account_ = {};
    else if (seen.alive)
        hear(seen.now);
    else
        miss(seen);
    return account_;
}

void LinkWatch::hear(double now)
{
    const bool wasDown =
        account_.standing == LinkStanding::Lost || account_.standing == LinkStanding::Unsteady;
    if (wasDown && !account_.alive) backSince_ = now;
    account_.alive = true;
    if (!wasDown || now - backSince_ >= kSteadyAfter) account_.standing = LinkStanding::Up;
}

void LinkWatch::miss(const LinkGlimpse& seen)
{
    const bool wasDown =
        account_.standing == LinkStanding::Lost || account_.standing == LinkStanding::Unsteady;
    if (!wasDown)
        account_ = {.standing = LinkStanding::Lost, .gaps = 1};
    else if (account_.alive) {
        account_.standing = LinkStanding::Unsteady;
        ++account_.gaps;
    }
    account_.alive = false;
    account_.alone = seen.othersCome;
    account_.longest = std::max(account_.longest, *seen.age);
    if (*seen.age > kMaxGap) account_.standing = LinkStanding::Lost;
}

}  // namespace terratact
