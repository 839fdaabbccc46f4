#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/runtime/steady_now.h"
#include "core/infer/sampling/watch.h"

namespace terratact {

/// Returns a watch that ends sampling `seconds` [s] after its first call. The first call comes after the first sweeps,
/// so a model's one-time preparation is not counted. 0: no limit. clock: returns seconds.
inline Watch endingAfter(double seconds, const std::function<double()>& clock = steadyNow)
{
    Watch watch;
    if (seconds > 0.0)
        watch.outOfTime = [seconds, clock, start = std::make_shared<std::optional<double>>()] {
            const double now = clock();
            if (!*start) *start = now;
            return now - **start >= seconds;
        };
    return watch;
}

}  // namespace terratact
