#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <utility>
#include <vector>

#include "tests/support/thread_time.h"

namespace terratact {

/// A timer of 2 ms in this thread's event loop; its lateness is the time the loop was blocked. On a busy machine other
/// programs add to it. Tests therefore judge the thread's processor time between two beats.
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

    qint64 late() const { return late_; }  ///< [ms] maximum
    /// Returns the own processor time [ms] that this share of the beats does not exceed; 1: all.
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
