#include "app/console/gamepad_control.h"

#include <QPushButton>
#include <cmath>
#include <utility>

#include "app/console/console_keys.h"
#include "app/console/main_window.h"
#include "widgets/base/held_button.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {

template <class Begin>
bool PadHold::poll(bool wanted, HeldButton& button, Begin begin)
{
    const bool held = std::exchange(holds_, false);
    const bool isNew = wanted && !std::exchange(wanted_, wanted);
    if (!wanted) {
        wanted_ = false;
        if (held) button.letGo();
        return true;
    }
    if (held) {
        holds_ = button.isHeld();
        return holds_;
    }
    if (!isNew || button.isHeld()) return true;  // a key or the mouse holds it
    begin();
    holds_ = button.isHeld();
    return true;
}

GamepadControl::GamepadControl(std::unique_ptr<Gamepad> gamepad, MeasurementSource& source,
                               MainWindow& window, GamepadReader::Clock clock)
    : window_(window), reader_(std::move(gamepad), source, std::move(clock))
{
}

void GamepadControl::poll(double now, bool mayAct)
{
    const PadSettings& settings = window_.preferences().current().pad;
    reader_.setStop(settings.mapping, !window_.exploration().following());
    const GamepadState before = std::exchange(state_, reader_.latest(now));
    if (reader_.consumeStops() > 0) stop();
    const bool held = forward_.holds() || back_.holds() || feel_.holds() || approve_.holds();
    const PadIntents intents = follower_.poll(state_, settings, mayAct);
    hold(intents);
    press(intents);
    showConnection(before);
    if (held && before.isConnected() && !state_.isConnected())
        emit happened(
            TR_NOOP("terratact::GamepadControl", "gamepad lost: all its controls are released"),
            EventSeverity::Bad);
}

void GamepadControl::stop()
{
    const Message where = TR_NOOP("terratact::GamepadControl", "STOP pressed on the gamepad");
    emit happened(where, EventSeverity::Bad);
    window_.exploration().stopFrom(where);
}

void GamepadControl::showConnection(const GamepadState& before)
{
    if (!state_.trouble.empty() && state_.trouble != before.trouble)
        emit happened(state_.trouble, EventSeverity::Warning);
    if (state_.connection == before.connection) return;
    if (!state_.isConnected())
        return void(emit happened(Message(TR_NOOP("terratact::GamepadControl",
                                                  "the gamepad “%1” is not connected any more"),
                                          before.name),
                                  EventSeverity::Warning));
    emit happened(
        Message(TR_NOOP("terratact::GamepadControl", "gamepad connected: %1"), state_.name),
        EventSeverity::Note);
    if (state_.radio)
        emit happened(TR_NOOP("terratact::GamepadControl",
                              "the gamepad is connected by radio, whose loss is noticed late: "
                              "connect it by cable"),
                      EventSeverity::Warning);
}

void GamepadControl::press(const PadIntents& intents)
{
    Exploration& exploration = window_.exploration();
    if (intents.explore)
        ifSeen(window_.atemPanel()->requestButton(), [&exploration] { exploration.request(); })();
    const auto click = [](bool pressed, QPushButton* button) {
        if (pressed) ifSeen(button, [button] { button->click(); })();
    };
    click(intents.refuse, window_.probeCard()->refuseButton());
    click(intents.raiseLimit, window_.verdict()->raiseButton());
    click(intents.lowerLimit, window_.verdict()->lowerButton());
    if (intents.stickWasFirst)
        window_.showWhyNot(TR_NOOP("terratact::GamepadControl",
                                   "not driven: hold the dead-man control first, then push the "
                                   "stick from its centre"));
}

void GamepadControl::hold(const PadIntents& intents)
{
    HeldButton* const approve = window_.probeCard()->approveButton();
    approve_.poll(intents.approve, *approve, [approve] { approve->hold(); });
    HeldButton* const feel = window_.drivePad()->feelButton();
    if (!feel_.poll(intents.feelForward, *feel, [this, feel] {
            holdToMove(*feel, window_, &Exploration::whyNotFeelingForward);
        }))
        follower_.release();
    drive(intents.speed);
}

void GamepadControl::drive(double speed)
{
    HeldButton* const forward = window_.drivePad()->forwardButton();
    HeldButton* const back = window_.drivePad()->backButton();
    const auto holds = [this](PadHold& hold, HeldButton* button, bool wanted) {
        return hold.poll(wanted, *button, [this, button] {
            holdToMove(*button, window_, &Exploration::whyNotDriving);
        });
    };
    // The other direction ends before this one begins.
    if (speed <= 0.0) holds(forward_, forward, false);
    if (speed >= 0.0) holds(back_, back, false);
    const bool isKeyHeld =
        (forward->isHeld() && !forward_.holds()) || (back->isHeld() && !back_.holds());
    if (speed != 0.0 && !isKeyHeld) window_.exploration().setDriveSpeed(std::abs(speed));
    const bool isHeld = speed > 0.0 ? holds(forward_, forward, true)
                      : speed < 0.0 ? holds(back_, back, true)
                                    : true;
    if (!isHeld) follower_.release();
    if (!forward_.holds() && !back_.holds()) window_.exploration().setDriveSpeed(std::nullopt);
}

}  // namespace terratact
