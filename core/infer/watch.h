#pragma once

#include <functional>

namespace terratact {

/// How a long computation talks to whoever waits: both may be empty, both are called from the thread
/// that computes.
struct Watch {
    std::function<bool()> cancelled;             ///< true ends the work with Cancelled
    std::function<void(double share)> progress;  ///< 0 … 1
};

/// Thrown by a computation whose Watch said "cancelled".
struct Cancelled {};

}  // namespace terratact
