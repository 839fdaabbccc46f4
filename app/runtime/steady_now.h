#pragma once

#include <chrono>
#include <ctime>

namespace terratact {

/// Converts a time point of the steady clock to seconds.
inline double secondsOf(std::chrono::steady_clock::time_point time)
{
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}
inline double steadyNow()
{
    return secondsOf(std::chrono::steady_clock::now());
}

/// Returns the time [s] of a clock that continues during suspend; the steady clock stops.
inline double sleeplessNow()
{
    timespec now{};
    ::clock_gettime(CLOCK_BOOTTIME, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace terratact
