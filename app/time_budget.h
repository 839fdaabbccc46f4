#pragma once

#include <chrono>

#include "core/infer/watch.h"

namespace terratact {

/// Ends sampling when so many seconds [s] have passed from now; 0: there is no limit.
inline Watch endingAfter(double seconds)
{
    using Clock = std::chrono::steady_clock;
    Watch watch;
    if (seconds > 0.0)
        watch.outOfTime = [seconds, start = Clock::now()] {
            return std::chrono::duration<double>(Clock::now() - start).count() >= seconds;
        };
    return watch;
}

}  // namespace terratact
