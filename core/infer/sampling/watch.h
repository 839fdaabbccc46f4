#pragma once

#include <functional>

#include "core/base/for_each.h"
#include "core/base/poll.h"

namespace terratact {

/// Callbacks between a long computation and its caller; all may be empty. `cancelled` and
/// `progress` are called from the computing threads, by one thread at a time.
struct Watch {
    std::function<bool()> cancelled;             ///< returns true to end the work with Cancelled
    std::function<void(double share)> progress;  ///< share: 0 … 1
    /// The calling thread calls this between sweeps, or every few sweeps where parts run in
    /// parallel. true ends sampling with the draws so far.
    std::function<bool()> outOfTime;
    /// Runs independent parts in parallel; empty: one after the other.
    ForEach sideBySide;
    /// Number of threads of sideBySide, and largest number of parts. 0: unknown, the parts are as
    /// small as possible.
    int threads = 0;
};

/// Thrown by a computation whose Watch::cancelled returned true.
struct Cancelled {};

/// Throws Cancelled if watch.cancelled returns true.
inline void stopIfCancelled(const Watch& watch)
{
    if (watch.cancelled && watch.cancelled()) throw Cancelled{};
}

/// Returns a poll that throws Cancelled if watch.cancelled returns true. It keeps a copy of
/// `cancelled`.
inline Poll pollOf(const Watch& watch)
{
    if (!watch.cancelled) return {};
    return [cancelled = watch.cancelled] {
        if (cancelled()) throw Cancelled{};
    };
}

}  // namespace terratact
