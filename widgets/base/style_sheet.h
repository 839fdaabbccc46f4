#pragma once

#include <QColor>
#include <QString>

namespace terratact {

struct Theme;

/// Returns the colour between two colours. shareOfB: 0 gives a, 1 gives b.
QColor mixed(const QColor& a, const QColor& b, double shareOfB);

/// Scales a length [px at 100 %] that must not grow: it is scaled() below 100 %, and the same above. GUI thread only.
int scaledSmall(int pixels);

/// Returns the style sheet of all windows (theme.qss) in the theme's colours and at the font scale in use (scaled()).
/// Throws std::logic_error for a placeholder without a value.
QString styleSheet(const Theme& theme);

}  // namespace terratact
