#pragma once

class QAction;

namespace terratact {

class KeyTable;
class MainWindow;

// The keys with which the operator commands robot and exploration, a group of the table each.

/// STOP, driving, arming.
void addRobotKeys(KeyTable& keys, MainWindow& window);
/// Asking for an exploration, answering its questions, reading its result.  draws: shows them in the terrain.
void addExplorationKeys(KeyTable& keys, MainWindow& window, QAction& draws);

}  // namespace terratact
