#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "core/infer/sampling/watch.h"

namespace terratact {

/// Ends sampling so many seconds [s] after it was first asked, which is after the first sweeps: what a model makes once
/// for all scenes is no part of a scene's time.  0: there is no limit.
inline Watch endingAfter(double seconds)
{
    using Clock = std::chrono::steady_clock;
    Watch watch;
    if (seconds > 0.0)
        watch.outOfTime = [seconds, start = std::make_shared<std::optional<Clock::time_point>>()] {
            if (!*start) *start = Clock::now();
            return std::chrono::duration<double>(Clock::now() - **start).count() >= seconds;
        };
    return watch;
}

}  // namespace terratact
