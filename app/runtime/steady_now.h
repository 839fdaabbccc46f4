#pragma once

#include <chrono>
#include <ctime>

namespace terratact {

/// [s] on the steady clock.
inline double secondsOf(std::chrono::steady_clock::time_point time)
{
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}
inline double steadyNow()
{
    return secondsOf(std::chrono::steady_clock::now());
}

/// [s] on the clock that goes on while this computer sleeps, which the steady one does not.
inline double sleeplessNow()
{
    timespec now{};
    ::clock_gettime(CLOCK_BOOTTIME, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace terratact
