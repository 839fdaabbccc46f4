#pragma once

#include <chrono>

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

}  // namespace terratact
