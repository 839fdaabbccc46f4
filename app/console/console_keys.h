#pragma once

class QAction;

namespace terratact {

class KeyTable;
class MainWindow;

// Key bindings of the console; each function adds one group to the table.

/// Adds STOP, driving and arming.
void addRobotKeys(KeyTable& keys, MainWindow& window);
/// Adds exploring, answering proposals, and reading results. draws: action that shows the draws in the terrain.
void addExplorationKeys(KeyTable& keys, MainWindow& window, QAction& draws);

}  // namespace terratact
