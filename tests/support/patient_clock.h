#pragma once

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "app/runtime/steady_now.h"
#include "tests/support/test_clock.h"

namespace terratact {

/// The machine's clock, but never further than kMaxAhead past the time that each of its threads read last. A busy
/// machine that delays one thread stops the time of all. No thread therefore seems silent to another. Time catches up
/// once they read again. A thread counts while it computes or waits for a processor or a disk. A thread that has ended,
/// or sleeps longer than kGone, is gone and does not count. A pause of the whole machine makes no thread gone. As long
/// as it exists, it is the testClock.
class PatientClock {
public:
    /// [s] a fifth of the shortest time limit between console and robot: a thread may read several times in one turn
    static constexpr double kMaxAhead = 0.02;
    /// [s] without a read, after which a sleeping thread is gone; longer pauses of all threads count as kPause
    static constexpr double kGone = 0.5;
    static constexpr double kPause = 0.05;
    /// [s] the same for the window's thread, which may paint for long
    static constexpr double kWindowGone = 10.0;

    PatientClock()
    {
        testClock = [this] { return time(); };
    }
    ~PatientClock() { testClock = nullptr; }
    PatientClock(const PatientClock&) = delete;
    PatientClock& operator=(const PatientClock&) = delete;

    /// Returns the time of the newest read of any thread [s].
    double time() const
    {
        const std::scoped_lock lock(mutex_);
        return time_;
    }
    /// Returns the time [s]; any thread may call it. The calling thread counts from now on.
    double now()
    {
        const std::scoped_lock lock(mutex_);
        const double machine = steadyNow();
        seen_ += std::min(machine - std::exchange(machine_, machine), kPause);
        const auto mine = reads_.find(::gettid());
        if (mine != reads_.end()) mine->second.seen = seen_;
        double until = machine;
        for (auto read = reads_.begin(); read != reads_.end();) {
            const bool waits = read->second.time + kMaxAhead < machine;
            const double gone = read->first == ::getpid() ? kWindowGone : kGone;
            const bool isSilent = seen_ - read->second.seen > gone;
            if (waits && ((isSilent && !isDelayed(read->first)) || hasEnded(read->first))) {
                read = reads_.erase(read);
                continue;
            }
            until = std::min(until, read->second.time + kMaxAhead);
            ++read;
        }
        time_ = std::max(time_, until);
        reads_[::gettid()] = {time_, seen_};
        return time_;
    }
    /// The calling thread does not count until it reads again: what it does then takes time.
    void leave()
    {
        const std::scoped_lock lock(mutex_);
        reads_.erase(::gettid());
    }
    /// Returns the time that the calling thread read last [s].
    double lastRead() const
    {
        const std::scoped_lock lock(mutex_);
        const auto read = reads_.find(::gettid());
        return read == reads_.end() ? time_ : read->second.time;
    }

private:
    struct Read {
        double time = 0.0;  ///< [s] of this clock
        double seen = 0.0;  ///< seen_ at that time
    };
    static bool hasEnded(pid_t thread) { return ::tgkill(::getpid(), thread, 0) != 0; }
    /// Returns true if the thread runs, or waits for a processor or a disk: the machine delays it.
    static bool isDelayed(pid_t thread)
    {
        std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/stat");
        std::string text;
        std::getline(file, text);
        const std::size_t name = text.rfind(") ");  // "17 (name) R …"
        return name != std::string::npos && (text[name + 2] == 'R' || text[name + 2] == 'D');
    }

    mutable std::mutex mutex_;  // guards the members below
    std::map<pid_t, Read> reads_;
    double time_ = steadyNow();
    double machine_ = time_;  ///< the machine's clock at the last read of any thread [s]
    double seen_ = 0.0;       ///< [s] of the machine's clock, without long pauses of all threads
};

}  // namespace terratact
