#pragma once

class QMenu;

namespace terratact {

class KeyTable;
class TerrainProfileView;

/// Adds the keys that show the left side, the right side or both sides of a two-track estimate. They act while the
/// picture is visible. probes: the key sheet also states that probes follow the shown side.
void addSideKeys(KeyTable& keys, TerrainProfileView& view, bool probes);

/// Adds the same choice, with probes, to a menu. The menu shows the present choice.
void addSideChoice(QMenu& menu, TerrainProfileView& view);

}  // namespace terratact
