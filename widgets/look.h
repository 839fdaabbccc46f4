#pragma once

class QApplication;
class QLabel;

namespace terratact {

/// Style, fonts, colours and style sheet of the console.  Call once, before the first window.
void applyLook(QApplication& application);

/// What a label says, as weight and colour.
enum class Tone { Plain, Muted, Strong, Good, Doubt, Bad, Accent };

/// Sets a label's tone; does nothing when it has it already, so it may be called at every redraw.
void setTone(QLabel& label, Tone tone);

}  // namespace terratact
