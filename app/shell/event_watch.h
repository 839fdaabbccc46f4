#pragma once

#include <QString>
#include <QTime>
#include <vector>

namespace terratact {

/// An event that kept the event loop, and with it the operator, waiting.
struct LongEvent {
    double seconds = 0.0;
    QString what{};  ///< "Timer for QTimer of terratact::MainWindow": for whoever reads the source
    QTime at{};      ///< of the day, when it was done
};

/// The events that took longest.  What an event sends while it is handled counts as part of it, but an event in which
/// another loop runs (a dialog, a menu) keeps nobody waiting: the events of that loop count instead.  No clock.
class EventWatch {
public:
    static constexpr std::size_t kKept = 3;

    /// A loop hands out an event; level: QThread::loopLevel(), 0 before there is a loop.  Whether it is to be timed,
    /// which means that ends() is to be called.
    bool begins(int level);
    /// The same event is done, after so many seconds; whether it is one of the longest, to be kept.
    bool ends(int level, double seconds);
    void keep(LongEvent event);

    const std::vector<LongEvent>& longest() const { return longest_; }  ///< the longest first

private:
    int timed_ = 0;    ///< level of the event that is being timed; 0: none
    int deepest_ = 0;  ///< level that was reached during that
    std::vector<int> outer_;
    std::vector<LongEvent> longest_;
};

}  // namespace terratact
