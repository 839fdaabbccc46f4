#pragma once

#include <QEvent>

class QWidget;

namespace terratact {

/// From now on every label says its name and its text to a screen reader ("Verdict: ✘ BLOCKED"); Qt's say the name alone
/// where there is one.  Needs the application; once is enough.
void installSpokenLabels();

/// Tells a screen reader that what a widget says matters now: QAccessible::Alert, and NameChanged for those that do not
/// hear alerts (AT-SPI in Qt 6.4).  The widget is sent an event of kAnnounced, too, whether or not a reader listens.
void announce(QWidget& widget);
inline constexpr auto kAnnounced = static_cast<QEvent::Type>(QEvent::User + 71);

}  // namespace terratact
