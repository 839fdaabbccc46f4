#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/clouds/scene_grid.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Correction of the cloud at a scene, DEM frame: z + offset + tiltX · x + tiltY · y.
struct CloudCorrection {
    double offset = 0.0;              ///< [m]
    double tiltX = 0.0, tiltY = 0.0;  ///< slopes
};

struct TruthRule {
    /// Percentile of a cell's heights that is the ground: 50 is the median, which outliers do not move. Less where
    /// plants stand.
    double percentile = 50.0;
    double maxSd = 0.03;  ///< [m] a bin with a larger sd is unknown
    double ownMargin =
        0.03;  ///< [m] of noise and pose: points higher above the robot's lower boundary are its own
    double placeSd = 0.0;  ///< [m] sd of the height between cloud and robot, part of every bin's sd
};

/// Ground in a cell.
struct CellGround {
    bool isKnown = false;
    double height = 0.0;  ///< [m]
    double sd = 0.0;      ///< [m] of the height, from spread and number of points
};

/// Returns the ground in the cells of a line. Points higher than ownMargin above
/// SceneGrid::ceiling() are the robot's own and left out. In a noisy cloud the margin is three
/// times the usual spread in a cell, at most 6 cm. Points may lie on two levels, with a gap of at
/// least 0.35 m. The lower level counts if it has a tenth of them: the robot drives under the other
/// one. A near cell without the lower level is unknown. The height is the percentile of the rest;
/// its sd is
///   s √(p (1 − p)) / φ(Φ⁻¹(p)) / √n.
/// s is the sample's sd. In cells with fewer than four points it is the line's median sd.
std::vector<CellGround> groundOf(const SceneGrid& grid, const RobotModel& robot, std::size_t place,
                                 TruthLine line, const CloudCorrection& correction,
                                 const TruthRule& rule);

/// True height of a bin, and what it rests on.
struct BinTruth {
    std::optional<double> height{};  ///< [m] DEM frame; empty: the cloud does not know
    double sd = 0.0;                 ///< [m] of a known height
    std::uint32_t points = 0;        ///< in its cells
    int cells = 0;                   ///< known of its five cells
};
using SideTruth = std::array<BinTruth, kBins>;

/// Returns the heights of one side: bins −0.3 … 0.2 m on the track's line, from 0.3 m on that of the flippers. A bin
/// is known if at least three of its cells are, and its sd is at most maxSd. Cells without points have the height
/// between their neighbours. Their sd d is half of these neighbours' difference. It is 5 cm if a neighbour is more than
/// a bin away. The sd's square is
///   placeSd² + (Σ sd_cell² + (Σ d)²) / 25
SideTruth sideTruth(const SceneGrid& grid, const RobotModel& robot, std::size_t place, Side side,
                    const CloudCorrection& correction, const TruthRule& rule);

/// Returns the heights of one plane: the mean of both sides. Half of their difference is part of the sd. A
/// bin that one side alone knows has that side's height.
SideTruth planeTruth(const SideTruth& left, const SideTruth& right, const TruthRule& rule);

}  // namespace terratact
