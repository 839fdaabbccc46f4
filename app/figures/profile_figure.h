#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/infer/estimate/estimate.h"
#include "core/terrain/outline.h"

namespace terratact {

class Canvas;

/// What a picture of one exploration shows.
struct FigureInput {
    TerrainEstimate estimate;
    std::optional<TerrainEstimate> previous;  ///< drawn pale, for comparison
    Outline outline;                          ///< of the robot, DEM frame [m]
    std::optional<Heights> truth;             ///< [m] where somebody knows it
    std::string title;
    std::optional<int> proposedBin;  ///< of the arm probe
};

/// Draws the terrain profile, 1200 × 700 px with equal axes [m], origin at the IMU: mean line, bars from the
/// 0.1 to the 0.9 quantile, ceilings, the robot; contact, arm, sampled and prior-only bins told apart by
/// shape as well as colour; under the title the method and what makes the result doubtful.  PNG or SVG by
/// the path's ending, under a temporary name, then renamed.  Errors name the file.
Status writeProfileFigure(const std::string& path, const FigureInput& input);

/// The same as a part of a larger picture: kProfileWidth × kProfileHeight from the canvas's origin.
void drawProfile(Canvas& canvas, const FigureInput& input);
inline constexpr int kProfileWidth = 1200, kProfileHeight = 700;  ///< [px]

/// The profile as a table for a person, one row per bin, rear to front, with a heading.
std::string profileTable(const TerrainEstimate& estimate, const std::optional<Heights>& truth);

}  // namespace terratact
