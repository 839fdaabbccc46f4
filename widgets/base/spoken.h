#pragma once

#include <QEvent>

class QWidget;

namespace terratact {

/// Gives screen readers the name and the text of every label ("Verdict: ✘ BLOCKED"). Qt's labels give only the name if
/// they have one. Needs the application; further calls do nothing.
void installSpokenLabels();

/// Announces a widget's text as urgent to screen readers. It sends QAccessible::Alert, and NameChanged for readers
/// without alerts (AT-SPI in Qt 6.4). The widget also gets a kAnnounced event, with or without a reader.
void announce(QWidget& widget);
inline constexpr auto kAnnounced = static_cast<QEvent::Type>(QEvent::User + 71);

}  // namespace terratact
