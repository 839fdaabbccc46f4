#pragma once

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "core/infer/sampling/watch.h"

namespace terratact {

/// Returns the number of processors this thread may use, within the limits of taskset or a batch system.
inline int processors()
{
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return CPU_COUNT(&allowed);
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Calls work(0) … work(count − 1) once each, on at most `most` threads including the caller's; 0: processors()
/// threads. Threads inherit the caller's priority. The first exception stops the others and is rethrown.
template <class Work>
void parallelFor(int count, Work work, int most = 0)
{
    std::atomic<int> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto run = [&] {
        for (int i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::scoped_lock lock(mutex);
                if (!failure) failure = std::current_exception();
                next = count;
            }
        }
    };
    const int threads = std::min(count, most > 0 ? most : processors());
    {
        std::vector<std::jthread> pool;
        for (int t = 1; t < threads; ++t) pool.emplace_back(run);
        run();
    }
    if (failure) std::rethrow_exception(failure);
}

/// Lets a computation run its parts in parallel on all processors().
inline void lendProcessors(Watch& watch)
{
    watch.threads = processors();
    watch.sideBySide = [](int count, const std::function<void(int)>& work) {
        parallelFor(count, work);
    };
}

}  // namespace terratact
