#pragma once

#include <QApplication>

#include "app/shell/event_watch.h"

namespace terratact {

/// A QApplication that records its longest events.
class WatchedApplication final : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;

    /// Returns the longest events of the running application since its loop began; empty if it has another class.
    static std::vector<LongEvent> longestEvents();

private:
    EventWatch watch_;
};

}  // namespace terratact
