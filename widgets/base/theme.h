#pragma once

#include "widgets/base/palette.h"

class QApplication;
class QLabel;

namespace terratact {

/// Style, fonts, colours and style sheet of the console.  Call before the first window; a later call changes
/// every window there is, each of whose widgets receives a QEvent::StyleChange.  fontScale: [%].
void applyLook(QApplication& application, ThemeName name = ThemeName::Day, int fontScale = 100);

/// What was applied last.
struct LookInForce {
    ThemeName theme = ThemeName::Day;
    int fontScale = 100;  ///< [%]
};
LookInForce lookInForce();

/// What a label says, as weight and colour.
enum class Tone { Plain, Muted, Strong, Good, Doubt, Bad, Accent };

/// Sets a label's tone; does nothing when it has it already, so it may be called at every redraw.
void setTone(QLabel& label, Tone tone);

}  // namespace terratact
