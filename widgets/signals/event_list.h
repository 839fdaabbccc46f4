#pragma once

#include <QListWidget>
#include <QTime>

#include "widgets/base/palette.h"

namespace terratact {

enum class Weight : std::uint8_t { Note, Doubt, Bad };  ///< how much an event matters

/// What happened in the last minutes, newest on top; older than the last 500 is dropped.
class EventList final : public QListWidget {
    Q_OBJECT
public:
    explicit EventList(QWidget* parent = nullptr);
    QSize sizeHint() const override { return {300, 110}; }
    QSize minimumSizeHint() const override { return {scaled(150), 80}; }
    void add(const QString& text, Weight weight, QTime at);
    /// The same of what is recorded by itself: without added().
    void tell(const QString& text, Weight weight, QTime at);

signals:
    void added(const QString& text, terratact::Weight weight);

protected:
    void changeEvent(QEvent* event) override;
};

}  // namespace terratact
