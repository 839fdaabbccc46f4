#pragma once

#include <QEvent>

class QWidget;

namespace terratact {

/// Makes every label tell a screen reader its name and its text ("Verdict: ✘ BLOCKED"). Qt's labels tell only the name
/// if they have one. Needs the application; further calls do nothing.
void installSpokenLabels();

/// Tells a screen reader that a widget's text is urgent. It sends QAccessible::Alert, and NameChanged for readers
/// without alerts (AT-SPI in Qt 6.4). The widget also gets a kAnnounced event, with or without a reader.
void announce(QWidget& widget);
inline constexpr auto kAnnounced = static_cast<QEvent::Type>(QEvent::User + 71);

}  // namespace terratact
