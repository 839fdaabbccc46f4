#pragma once

#include "app/display/tone.h"
#include "widgets/base/palette.h"

class QApplication;
class QLabel;

namespace terratact {

/// Applies style, fonts, colours and style sheet to the console. Call before the first window opens. A later call
/// restyles all windows; each of their widgets gets QEvent::StyleChange, those of hidden pages later
/// (hidden_pages.h). fontScale: [%].
void applyLook(QApplication& application, ThemeName name = ThemeName::Day, int fontScale = 100);

/// Values of the last applyLook() call.
struct LookInForce {
    ThemeName theme = ThemeName::Day;
    int fontScale = 100;  ///< [%]
};
LookInForce lookInForce();

/// Sets a label's tone. An unchanged tone costs nothing, so every redraw may call this.
void setTone(QLabel& label, Tone tone);

}  // namespace terratact
