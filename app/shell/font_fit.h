#pragma once

#include <QSize>
#include <QString>

class QWidget;

namespace terratact {

/// The next letters [%] to try where those of `percent` made a window need more than its room [px]: in steps of
/// kLetterStep down from them, kSmallestFont at the least.  Sizes that do not fit even if all that the window needs
/// shrinks with its letters are left out.
int smallerLetters(int percent, QSize needs, QSize room);

inline constexpr int kLetterStep = 10;  ///< [%]

/// Makes every layout in the widget ask its parts anew what they need: they remember it until the events of a change
/// have arrived.
void forgetSizes(QWidget& widget);

/// That the letters in force are smaller than the wanted ones, and why; empty: they are not.
QString lettersNote(int wanted);

}  // namespace terratact
