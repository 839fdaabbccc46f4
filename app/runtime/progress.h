#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

namespace terratact {

/// Progress of a long command: one line on stderr, on a terminal only and after one second. tick() may be called from
/// any thread.
class Progress {
public:
    Progress(std::string what, int total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void tick();
    /// Sets the number of finished items.
    void reach(int done);

private:
    void show(int done);

    std::string what_;
    int total_;
    bool terminal_;
    std::atomic<int> done_{0};
    std::mutex mutex_;
    std::chrono::steady_clock::time_point start_, shown_;
    bool printed_ = false;
};

}  // namespace terratact
