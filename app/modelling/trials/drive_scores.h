#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Scores of one method over the scenes of drives. Errors of both sides count on two tracks.
struct DriveScores {
    std::string name;                 ///< "local", "trail"
    double median = 0.0, mean = 0.0;  ///< |error| over the bins −0.3 … 0.5 m [m]
    double in80 = 0.0;                ///< share of known truths within q10 … q90, the same bins
    std::array<double, kBins> medians{}, means{}, cover{};  ///< by bin
    double cpu = 0.0;  ///< median processor time of an estimate, of all scenes [s]
};

/// A scene's bins against the truth, of one side.
struct JudgedSide {
    std::array<double, kBins> error{};  ///< |height − truth| [m]; NaN without a truth
    std::array<bool, kBins> inside{};   ///< the truth is known, and within q10 … q90
    bool isEarly = false;               ///< at the begin of a drive
};

JudgedSide judgedSide(const TerrainEstimate& estimate, const OptionalHeights& truth, bool early);

/// Returns the scores of the sides with isEarly = `early`; NaN where there is no truth. cpu: of each estimate [s].
DriveScores scoresOf(const std::string& name, const std::vector<JudgedSide>& sides, bool early,
                     const std::vector<double>& cpu);

}  // namespace terratact
