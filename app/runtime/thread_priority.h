#pragma once

#include <sys/resource.h>

#include <algorithm>

namespace terratact {

/// Lowers the priority of the calling thread, and of the threads it will start, to this nice value at least (0 … 19).
inline void lowerPriority(int nice)
{
    setpriority(PRIO_PROCESS, 0, std::max(nice, getpriority(PRIO_PROCESS, 0)));
}

}  // namespace terratact
