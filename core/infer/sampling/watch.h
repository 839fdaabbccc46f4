#pragma once

#include <functional>

#include "core/base/for_each.h"
#include "core/base/poll.h"

namespace terratact {

/// How a long computation talks to whoever waits; all may be empty.  The first two are called from the threads
/// that compute, by one at a time.
struct Watch {
    std::function<bool()> cancelled;             ///< true ends the work with Cancelled
    std::function<void(double share)> progress;  ///< 0 … 1
    /// Asked between sweeps, every few where parts run side by side, by the thread that called; true ends
    /// sampling with what there is.
    std::function<bool()> outOfTime;
    /// Runs parts that do not depend on each other; empty: one after the other.
    ForEach sideBySide;
    /// That sideBySide runs them on, and so many parts there are at most; 0: unknown, the parts are as small as can be.
    int threads = 0;
};

/// Thrown by a computation whose Watch said "cancelled".
struct Cancelled {};

/// Throws Cancelled if the watch says so.
inline void stopIfCancelled(const Watch& watch)
{
    if (watch.cancelled && watch.cancelled()) throw Cancelled{};
}

/// The same as a poll; keeps a copy of `cancelled`.
inline Poll pollOf(const Watch& watch)
{
    if (!watch.cancelled) return {};
    return [cancelled = watch.cancelled] {
        if (cancelled()) throw Cancelled{};
    };
}

}  // namespace terratact
