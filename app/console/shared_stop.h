#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <string>

#include "app/mission/exploration.h"
#include "app/shell/remote_stop.h"
#include "core/base/message.h"

namespace terratact {

/// STOP between windows of several processes. A console that commands a robot accepts STOP from windows it has opened.
/// A console that stops nothing forwards STOP to the console that opened it. GUI thread only.
class SharedStop final : public QObject {
    Q_OBJECT
public:
    /// exploration: of this console; it must outlive the object.
    explicit SharedStop(Exploration& exploration, QObject* parent = nullptr);

    /// Starts listening; happened() may report at once that it failed.
    void listen();
    /// Handles STOP presses of other windows; call often.
    void poll();
    /// Returns the line for windows opened from here; empty: this console stops nothing.
    std::string line() const;
    /// Returns true if another console takes the STOP of this one.
    bool hasOther() const { return remote_.exists(); }

signals:
    void happened(const terratact::Message& text, terratact::EventSeverity severity);
    /// STOP was pressed elsewhere; Exploration::decided() records it, too.
    void received(const terratact::Message& text);
    void reported(const terratact::Message& text);  ///< important text for a banner

private:
    void stoppedNothing(const Message& why);

    Exploration& exploration_;
    std::optional<StopLine> line_;
    RemoteStop remote_;
};

}  // namespace terratact
