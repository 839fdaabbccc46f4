#pragma once

#include <ctime>

namespace terratact {

/// Returns the processor time of the calling thread so far [ms]; other programs do not count.
inline double threadMilliseconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace terratact
