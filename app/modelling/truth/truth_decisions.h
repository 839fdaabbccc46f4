#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/modelling/truth/laser_truth.h"
#include "core/base/result.h"

namespace terratact {

/// A person's decision on the heights of one scene.
struct TruthDecision {
    enum class Kind : std::uint8_t {
        Accept,   ///< keep them, with the nudge
        Exclude,  ///< leave them out
    };
    std::size_t row = 0;  ///< of the scenes file, from 1, as the contact sheet names it
    std::string run{};    ///< of that row; empty: any
    Kind kind = Kind::Accept;
    double offset = 0.0;  ///< [m] added to the heights
    double tilt = 0.0;    ///< [rad] tan(tilt) · x is added, too: positive lifts the ground ahead
    double along =
        0.0;  ///< [m] by which the cloud is moved ahead under the robot, before offset and tilt
    int line = 0;  ///< of the file of decisions; 0: none

    /// Returns what offset and tilt add to a height at x of the DEM frame [m].
    double nudgeAt(double x) const;
    /// Returns `along` in cells of the cloud.
    int cellsAlong() const;
};

inline constexpr double kMaxNudge = 0.2;                               ///< [m]
inline constexpr double kMaxNudgeTilt = 0.17;                          ///< [rad]
inline constexpr double kMaxNudgeAlong = kMaxCellsMoved * kTruthCell;  ///< [m]

/// Returns the grid with the cells of a row, whose place is 0. Errors name the file that does not hold them.
using CellsOfRow = std::function<Result<SceneGrid>(std::size_t row)>;

/// Reads a CSV with the columns row,run,decision,offset_m,tilt_rad,along_m in this order; decision is accept or
/// exclude. The last column may be missing. Empty numbers are 0. Errors name the file and the line. Causes: another
/// header or decision, a row that is no whole number or occurs twice, a nudge beyond the limits. along_m must be whole
/// cells.
Result<std::vector<TruthDecision>> readTruthDecisions(const std::string& path);

/// Returns decisions as such a CSV. Numbers are the shortest that read back equal.
std::string truthDecisionsCsv(const std::vector<TruthDecision>& decisions);

/// Returns Done if every decision belongs to a scene. Errors name the file and the line: there is no such row, or it
/// belongs to another run.
Status checkTruthDecisions(const LaserTruth& truth, const std::vector<TruthDecision>& decisions,
                           const std::string& path);

/// Applies decisions. Heights of excluded scenes become unknown. Heights of nudged scenes move, and the slices of the
/// contact sheet move with them. Scenes without a decision stay. A nudge along samples the heights again, from the
/// truth's grid or else from `cells`. An error of checkTruthDecisions() changes nothing. After an error of `cells` the
/// truth must not be used.
Status applyTruthDecisions(LaserTruth& truth, const std::vector<TruthDecision>& decisions,
                           const std::string& path, const CellsOfRow& cells = {});

/// Samples the heights of a scene again, with the cloud of this place moved ahead by the decision. Scenes without a
/// place or off the cloud stay as they are.
void sampleAlong(SceneTruth& scene, const LaserTruth& truth, SceneGrid& grid, std::size_t place,
                 const TruthDecision& decision);

}  // namespace terratact
