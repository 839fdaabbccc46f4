#pragma once

#include <QCoreApplication>

#include "widgets/control/status_header.h"

class QLabel;

namespace terratact {

/// Shows the state of STOP: on its button, and in a banner until the robot has confirmed it. GUI thread only.
class StopDisplay {
    Q_DECLARE_TR_FUNCTIONS(StopDisplay)
public:
    /// [s] a later confirmation is reported as late
    static constexpr double kConfirmsWithin = 0.3;

    /// Both arguments must outlive the object.
    StopDisplay(StatusHeader& header, QLabel& banner);

    void show(const StopViewState& viewState);
    bool isLate() const;  ///< the banner is visible and needs its whole line

private:
    static QString late(const StopViewState& viewState);

    StatusHeader& header_;
    QLabel& banner_;
};

}  // namespace terratact
