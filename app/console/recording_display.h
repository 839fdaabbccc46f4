#pragma once

#include <QCoreApplication>

#include "app/recording/session_recorder.h"

class QLabel;
class QPushButton;

namespace terratact {

/// Says whether the session is recorded: on the button that marks a moment, and, where recording fails, in a strip
/// over the whole width.
class RecordingDisplay {
    Q_DECLARE_TR_FUNCTIONS(RecordingDisplay)
public:
    /// Both must outlive it.
    RecordingDisplay(QPushButton& button, QLabel& strip);

    void show(const RecordingState& state);

private:
    QPushButton& button_;
    QLabel& strip_;
};

}  // namespace terratact
