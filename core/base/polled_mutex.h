#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "core/base/poll.h"

namespace terratact {

/// Mutex for long work: a waiting thread calls its poll every few milliseconds.
class PolledMutex {
public:
    /// Holds the mutex during its lifetime.
    class Lock {
    public:
        /// Rethrows what the poll throws while waiting; the mutex is then not held.
        Lock(PolledMutex& mutex, const Poll& poll) : mutex_(mutex) { mutex_.take(poll); }
        ~Lock() { mutex_.release(); }
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;

    private:
        PolledMutex& mutex_;
    };

private:
    void take(const Poll& poll)
    {
        std::unique_lock lock(mutex_);
        while (taken_) {
            free_.wait_for(lock, std::chrono::milliseconds(5));
            if (!taken_) break;
            lock.unlock();
            callPoll(poll);
            lock.lock();
        }
        taken_ = true;
    }

    void release()
    {
        {
            const std::scoped_lock lock(mutex_);
            taken_ = false;
        }
        free_.notify_one();
    }

    std::mutex mutex_;  // guards taken_
    std::condition_variable free_;
    bool taken_ = false;
};

}  // namespace terratact
