#pragma once

class QWidget;

namespace terratact {

/// From now on every label says its name and its text to a screen reader ("Verdict: ✘ BLOCKED"); Qt's say the name alone
/// where there is one.  Needs the application; once is enough.
void installSpokenLabels();

/// Tells a screen reader that what a widget says matters now: QAccessible::Alert, and NameChanged for those that do not
/// hear alerts (AT-SPI in Qt 6.4).
void announce(QWidget& widget);

}  // namespace terratact
