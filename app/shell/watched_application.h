#pragma once

#include <QApplication>

#include "app/shell/event_watch.h"

namespace terratact {

/// A QApplication that knows which of its events took longest.
class WatchedApplication final : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;

    /// Of the application that runs, since its loop began; empty where that is not of this class.
    static std::vector<LongEvent> longestEvents();

private:
    EventWatch watch_;
};

}  // namespace terratact
