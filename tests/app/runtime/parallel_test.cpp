#include "app/runtime/parallel.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

namespace terratact {
namespace {

/// Restricts this thread, and those it starts, to its first processor; the destructor restores all.
class OneProcessor {
public:
    OneProcessor()
    {
        sched_getaffinity(0, sizeof before_, &before_);
        cpu_set_t one;
        CPU_ZERO(&one);
        for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++cpu)
            if (CPU_ISSET(cpu, &before_)) CPU_SET(cpu, &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    ~OneProcessor() { sched_setaffinity(0, sizeof before_, &before_); }
    OneProcessor(const OneProcessor&) = delete;
    OneProcessor& operator=(const OneProcessor&) = delete;

private:
    cpu_set_t before_{};
};

TEST(ParallelFor, doesEveryPieceOnce)
{
    std::array<std::atomic<int>, 100> done{};
    parallelFor(100, [&](int k) { ++done[static_cast<std::size_t>(k)]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
    parallelFor(0, [](int) { FAIL(); });
}

TEST(ParallelFor, throwsWhatAPieceThrows)
{
    EXPECT_THROW(parallelFor(50,
                             [](int k) {
                                 if (k == 20) throw std::runtime_error("20");
                             }),
                 std::runtime_error);
}

TEST(ParallelFor, takesNoMoreThreadsThanItMayUse)
{
    EXPECT_GE(processors(), 1);
    const OneProcessor one;
    EXPECT_EQ(processors(), 1);
    std::mutex mutex;
    std::set<std::thread::id> threads;
    parallelFor(20, [&](int) {
        std::this_thread::sleep_for(
            std::chrono::milliseconds(1));  // a wrong second thread gets a turn
        const std::scoped_lock lock(mutex);
        threads.insert(std::this_thread::get_id());
    });
    EXPECT_EQ(threads, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(ParallelFor, isLentToAComputationWithItsProcessorCount)
{
    Watch watch;
    lendProcessors(watch);
    EXPECT_EQ(watch.threads, processors());
    std::array<std::atomic<int>, 7> done{};
    watch.sideBySide(7, [&](int k) { ++done[static_cast<std::size_t>(k)]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
    const OneProcessor one;
    lendProcessors(watch);
    EXPECT_EQ(watch.threads, 1);
}

}  // namespace
}  // namespace terratact
