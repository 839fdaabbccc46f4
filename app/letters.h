#pragma once

#include <QSize>
#include <QString>
#include <functional>

class QWidget;

namespace terratact {

/// The largest letters [%] of at most `wanted` with which a window needs no more than `room`, in steps of kLetterStep
/// down from the wanted ones; kSmallestFont where none do.  needs: what it needs [px] with letters of so many %.
int lettersThatFit(int wanted, QSize room, const std::function<QSize(int)>& needs);

inline constexpr int kLetterStep = 10;  ///< [%]

/// Makes every layout in the widget ask its parts anew what they need: they remember it until the events of a change
/// have arrived.
void forgetSizes(QWidget& widget);

/// That the letters in force are smaller than the wanted ones, and why; empty: they are not.
QString lettersNote(int wanted);

}  // namespace terratact
