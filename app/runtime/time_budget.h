#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "core/infer/sampling/watch.h"

namespace terratact {

/// Returns a watch that ends sampling `seconds` [s] after its first call. The first call comes after the first sweeps,
/// so a model's one-time preparation is not counted. 0: no limit.
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
