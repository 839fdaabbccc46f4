#pragma once

#include <QCoreApplication>

#include "widgets/control/status_header.h"

class QLabel;

namespace terratact {

/// Says what is known of STOP: on its button, and in a banner over the whole width as long as the robot has not
/// confirmed it.  GUI thread only.
class StopDisplay {
    Q_DECLARE_TR_FUNCTIONS(StopDisplay)
public:
    /// [s] a robot may take to confirm before that is called late
    static constexpr double kConfirmsWithin = 0.3;

    /// Both must outlive it.
    StopDisplay(StatusHeader& header, QLabel& banner);

    void show(const StopViewState& viewState);
    bool isLate() const;  ///< the banner is there, and needs all of its line

private:
    static QString late(const StopViewState& viewState);

    StatusHeader& header_;
    QLabel& banner_;
};

}  // namespace terratact
