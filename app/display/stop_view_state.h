#pragma once

#include <QString>

namespace terratact {

/// Known state of STOP.
struct StopViewState {
    enum class State {
        Ready,      ///< not requested
        Sent,       ///< requested, not yet confirmed by the robot
        NotSent,    ///< requested, but not sent
        Confirmed,  ///< confirmed: the robot reports stopped
        /// Sent to the console that opened this window, which reports the result.
        Elsewhere,
        NoEffect,  ///< this window sends no commands, not even STOP
    };
    State state = State::Ready;
    double seconds = 0.0;  ///< [s] since the request, in Sent and NotSent
    QString why{};         ///< text of the reason, in NotSent and NoEffect
};

}  // namespace terratact
