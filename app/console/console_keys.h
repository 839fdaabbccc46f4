#pragma once

#include <functional>
#include <optional>

#include "app/mission/exploration.h"

class QAction;
class QWidget;

namespace terratact {

class HeldButton;
class KeyTable;
class MainWindow;

// Keys and gamepad controls call the same functions.

/// Holds a button that moves the robot (dead-man control). If that has no effect, shows the reason.
void holdToMove(HeldButton& button, MainWindow& window,
                std::optional<Message> (Exploration::*whyNot)() const);

/// Returns a function that acts only while this control is visible and enabled: the button of the same action, or the
/// panel that shows its result.
std::function<void()> ifSeen(const QWidget* control, std::function<void()> act);

// Key bindings of the console; each function adds one group to the table.

/// Adds STOP, driving and arming.
void addRobotKeys(KeyTable& keys, MainWindow& window);
/// Adds exploring, answering proposals, and reading results. draws: action that shows the draws in the terrain.
void addExplorationKeys(KeyTable& keys, MainWindow& window, QAction& draws);

}  // namespace terratact
