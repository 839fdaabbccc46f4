#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <string>

#include "app/mission/exploration.h"
#include "app/shell/remote_stop.h"

namespace terratact {

/// STOP between the windows of several programs: a console that commands a robot takes it from those that were opened
/// from it, and one that stops nothing hands it on to the console that has opened it.  GUI thread only.
class SharedStop final : public QObject {
    Q_OBJECT
public:
    /// exploration: of this console; it must outlive it.
    explicit SharedStop(Exploration& exploration, QObject* parent = nullptr);

    /// Begins to take it; happened() may tell at once that it cannot.
    void listen();
    /// To be called often: takes what was pressed elsewhere.
    void poll();
    /// Where windows that are opened from here send theirs; empty: here it stops nothing.
    std::string line() const;
    /// Where this console stops nothing, another does.
    bool hasOther() const { return remote_.exists(); }

signals:
    void happened(const QString& text, terratact::Weight weight);
    void taken(
        const QString& text);  ///< STOP was pressed elsewhere; Exploration::decided() tells it, too
    void said(const QString& text);  ///< so that nobody overlooks it

private:
    void stoppedNothing(const QString& why);

    Exploration& exploration_;
    std::optional<StopLine> line_;
    RemoteStop remote_;
};

}  // namespace terratact
