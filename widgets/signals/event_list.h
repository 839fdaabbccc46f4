#pragma once

#include <QListWidget>
#include <QTime>

#include "app/display/event_severity.h"
#include "core/base/message.h"
#include "widgets/base/palette.h"

namespace terratact {

/// Events of this run, newest on top. Only the newest 500 are kept.
class EventList final : public QListWidget {
    Q_OBJECT
public:
    explicit EventList(QWidget* parent = nullptr);
    QSize sizeHint() const override { return {300, 110}; }
    QSize minimumSizeHint() const override { return {scaled(150), 80}; }
    void add(const Message& text, EventSeverity severity, QTime at,
             EventPlace place = EventPlace::ListOnly);
    /// Adds a text that is the same in every language, or that no session holds.
    void add(const QString& text, EventSeverity severity, QTime at);
    /// Adds an event without emitting added(), because the session records it elsewhere.
    void log(const QString& text, EventSeverity severity, QTime at);

signals:
    void added(const terratact::Message& text, terratact::EventSeverity severity,
               terratact::EventPlace place);

protected:
    void changeEvent(QEvent* event) override;
};

}  // namespace terratact
