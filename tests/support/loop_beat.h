#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <utility>
#include <vector>

#include "tests/support/thread_time.h"

namespace terratact {

/// A beat every 2 ms in this thread's event loop; what it is late is how long the loop was blocked.  On a busy machine
/// it is also late by what others computed, so the thread's own processor time between two beats is what a test can
/// judge.
class LoopBeat {
public:
    LoopBeat()
    {
        timer_.setTimerType(Qt::PreciseTimer);
        QObject::connect(&timer_, &QTimer::timeout, [this] {
            late_ = std::max(late_, since_.restart());
            const double now = threadMilliseconds();
            own_.push_back(now - std::exchange(before_, now));
        });
        since_.start();
        timer_.start(2);
    }
    void stop() { timer_.stop(); }

    qint64 late() const { return late_; }  ///< [ms] at most
    /// [ms] of the thread's own that such a share of the beats took at most; 1: all.
    double own(double share) const
    {
        if (own_.empty()) return 0.0;
        std::vector<double> sorted = own_;
        std::sort(sorted.begin(), sorted.end());
        return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(
                                                      share * static_cast<double>(sorted.size())))];
    }

private:
    QTimer timer_;
    QElapsedTimer since_;
    qint64 late_ = 0;
    double before_ = threadMilliseconds();
    std::vector<double> own_;
};

}  // namespace terratact
