#pragma once

#include <optional>
#include <string>

#include "core/clouds/scene_grid.h"

namespace terratact {

/// Returns the cells of a place as a truth file stores them. The order is `most`, number of cells, counts, ceilings,
/// heights. Each number has 4 bytes, little endian.
std::string storedCells(const PlaceCells& cells);

/// Reads them; empty: the bytes are not of this form. SceneGrid::restored() checks the values.
std::optional<PlaceCells> cellsFrom(const std::string& bytes);

}  // namespace terratact
