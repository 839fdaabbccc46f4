#pragma once

#include <QObject>
#include <memory>

#include "app/display/event_severity.h"
#include "app/link/gamepad/gamepad_reader.h"
#include "core/base/message.h"

namespace terratact {

class HeldButton;
class MainWindow;

/// A button of the window that the gamepad holds, as a key does. Only a new press of the gamepad begins a hold.
class PadHold {
public:
    bool holds() const { return holds_; }
    /// begin: begins the hold, or shows why it cannot. Returns false if something else has ended the hold.
    template <class Begin>
    bool poll(bool wanted, HeldButton& button, Begin begin);

private:
    bool wanted_ = false;  ///< by the poll before
    bool holds_ = false;
};

/// Presses the window's buttons and keys for the gamepad. It sends nothing to the robot itself.
/// GUI thread only.
class GamepadControl final : public QObject {
    Q_OBJECT
public:
    /// The source must outlive the object. clock: monotonic clock [s] of `now` and of the gamepad's reader.
    GamepadControl(std::unique_ptr<Gamepad> gamepad, MeasurementSource& source, MainWindow& window,
                   GamepadReader::Clock clock);

    /// Reads the gamepad and acts. now: that clock [s]. mayAct: the operator is at the window; otherwise only STOP
    /// acts.
    void poll(double now, bool mayAct);
    /// Lets go of everything: each control must be released before it counts again.
    void release() { follower_.release(); }

    const GamepadState& state() const { return state_; }

signals:
    void happened(const terratact::Message& text, terratact::EventSeverity severity);

private:
    void showConnection(const GamepadState& before);
    void stop();
    void press(const PadIntents& intents);
    void hold(const PadIntents& intents);
    void drive(double speed);

    MainWindow& window_;
    GamepadReader reader_;
    PadFollower follower_;
    GamepadState state_;
    PadHold forward_, back_, feel_, approve_;
};

}  // namespace terratact
