#pragma once

#include <QString>
#include <QTime>
#include <vector>

namespace terratact {

/// An event that blocked the event loop.
struct LongEvent {
    double seconds = 0.0;
    QString what{};  ///< developer text: "Timer for QTimer of terratact::MainWindow"
    QTime at{};      ///< time of day when it ended
};

/// Keeps the longest events. An event includes the events it sends while it is handled. An event that runs a nested
/// loop (dialog, menu) does not block; the nested loop's events count instead. It has no clock.
class EventWatch {
public:
    static constexpr std::size_t kKept = 3;

    /// Call when a loop dispatches an event. level: QThread::loopLevel(), 0 before the loop runs. Returns true if the
    /// event must be timed; then call ends().
    bool begins(int level);
    /// Call when the event has ended. Returns true if it is among the longest; then call keep().
    bool ends(int level, double seconds);
    void keep(LongEvent event);

    const std::vector<LongEvent>& longest() const { return longest_; }  ///< longest first

private:
    int timed_ = 0;    ///< loop level of the timed event; 0: none
    int deepest_ = 0;  ///< deepest level reached during the timed event
    std::vector<int> outer_;
    std::vector<LongEvent> longest_;
};

}  // namespace terratact
