#include "app/console/past/recording_display.h"

#include <QLabel>
#include <QPushButton>
#include <QStyle>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "widgets/base/tips.h"

namespace terratact {

RecordingDisplay::RecordingDisplay(QPushButton& button, QLabel& strip)
    : button_(button), strip_(strip)
{
    button_.setProperty("role", "quiet");
    strip_.setVisible(false);
}

void RecordingDisplay::show(const RecordingState& state)
{
    const bool failed = state.on && !state.trouble.empty();
    strip_.setVisible(failed);
    if (failed) strip_.setText(tr("NOT RECORDED: %1").arg(translated(state.trouble)));
    setTip(
        button_,
        state.recording
            ? tr("Recorded: %1\n%2 frames, %3 MB; %4 frames dropped\nA click marks this moment (K)")
                  .arg(format::line(state.path))
                  .arg(state.frames)
                  .arg(format::number(static_cast<double>(state.bytes) / 1e6, 1))
                  .arg(state.missing)
            : tr("Nothing is recorded"));
    const QString text = failed    ? tr("✕ NOT\nRECORDED")
                       : !state.on ? tr("○ not\nrecorded")
                                   : tr("● REC\nmark K");
    if (button_.text() == text) return;
    button_.setText(text);
    button_.setAccessibleName(failed || !state.on ? tr("Not recorded")
                                                  : tr("Recording; mark this moment"));
    button_.setProperty("role", failed ? "alarm" : "quiet");
    button_.style()->unpolish(&button_);
    button_.style()->polish(&button_);
}

}  // namespace terratact
