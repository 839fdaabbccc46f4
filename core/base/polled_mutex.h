#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "core/base/poll.h"

namespace terratact {

/// A mutex for long work: a thread that waits for it asks every few milliseconds whether it is still wanted.
class PolledMutex {
public:
    /// Holds the mutex while it lives.
    class Lock {
    public:
        /// What the poll throws while waiting comes out of here; the mutex is then not held.
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

    std::mutex mutex_;  // of `taken_`
    std::condition_variable free_;
    bool taken_ = false;
};

}  // namespace terratact
