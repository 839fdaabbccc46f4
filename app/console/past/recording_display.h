#pragma once

#include <QCoreApplication>

#include "app/recording/session_recorder.h"

class QLabel;
class QPushButton;

namespace terratact {

/// Shows whether the session is recorded: on the marker button, and in a strip if recording fails.
class RecordingDisplay {
    Q_DECLARE_TR_FUNCTIONS(RecordingDisplay)
public:
    /// Both arguments must outlive the object.
    RecordingDisplay(QPushButton& button, QLabel& strip);

    void show(const RecordingState& state);

private:
    QPushButton& button_;
    QLabel& strip_;
};

}  // namespace terratact
