#pragma once

#include <chrono>
#include <thread>

#include "core/infer/sampling/watch.h"

namespace terratact {

/// Blocks an estimate while the condition is true. Throws Cancelled once the watch is cancelled. A watch gives no event
/// and can only be asked, so it is asked every millisecond.
template <class Condition>
void waitWhile(Condition&& held, const Watch& watch)
{
    while (held()) {
        stopIfCancelled(watch);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

}  // namespace terratact
