#pragma once

#include <optional>
#include <string>

#include "app/figures/wording.h"
#include "core/base/result.h"
#include "core/infer/estimate/estimate.h"
#include "core/store/file_group.h"
#include "core/terrain/outline.h"

namespace terratact {

class Canvas;

/// Content of a picture of one exploration.
struct FigureInput {
    TerrainEstimate estimate;
    std::optional<TerrainEstimate> previous;  ///< drawn pale, for comparison
    Outline outline;                          ///< outline of the robot, DEM frame [m]
    std::optional<Heights> truth;             ///< [m], if known
    std::string title;
    std::optional<int> proposedBin;  ///< bin of the proposed probe
    Wording wording = inEnglish;     ///< makes the texts
};

/// Draws the terrain profile, 1200 × 700 px, with equal axes [m] and the origin at the IMU. It shows the mean line,
/// bars from the 0.1 to the 0.9 quantile, ceilings and the robot. Contact, arm, sampled and prior-only bins differ by
/// shape and colour. Method and warnings stand under the title.
/// The file is PNG or SVG by its ending, written under a temporary name and renamed. Errors name the file.
Status writeProfileFigure(const std::string& path, const FigureInput& input,
                          const FileWriter& write = {});

/// Draws the profile as part of a larger picture: kProfileWidth × kProfileHeight from the canvas's origin.
void drawProfile(Canvas& canvas, const FigureInput& input);
inline constexpr int kProfileWidth = 1200, kProfileHeight = 700;  ///< [px]

/// Returns the profile as a table for the terminal with a heading, one row per bin from rear to front.
std::string profileTable(const TerrainEstimate& estimate, const std::optional<Heights>& truth);

}  // namespace terratact
