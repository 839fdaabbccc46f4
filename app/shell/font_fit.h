#pragma once

#include <QSize>
#include <QString>

class QWidget;

namespace terratact {

/// Returns the next smaller font scale [%] to try after `percent` needed more than the room [px]. Scales go down in
/// steps of kFontStep to kSmallestFont. Scales that cannot fit, even if everything shrinks with the font, are
/// skipped.
int smallerFont(int percent, QSize needs, QSize room);

inline constexpr int kFontStep = 10;  ///< [%]

/// Invalidates every cached size hint of layouts in the widget; Qt keeps them until the events of a change arrive.
void forgetSizes(QWidget& widget);

/// Returns a note that the current font scale is smaller than the wanted one, and why; empty: it is not.
QString fontNote(int wanted);

}  // namespace terratact
