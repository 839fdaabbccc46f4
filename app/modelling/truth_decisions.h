#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/modelling/laser_truth.h"
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
    int line = 0;         ///< of the file of decisions; 0: none

    /// Returns what the nudge adds to a height at x of the DEM frame [m].
    double nudgeAt(double x) const;
};

inline constexpr double kMaxNudge = 0.2;       ///< [m]
inline constexpr double kMaxNudgeTilt = 0.17;  ///< [rad]

/// Reads a CSV with the columns row,run,decision,offset_m,tilt_rad in this order; decision is accept or exclude. Empty
/// numbers are 0. Errors name the file and the line: another header or decision, a row that is no whole number or
/// twice there, a nudge beyond the limits.
Result<std::vector<TruthDecision>> readTruthDecisions(const std::string& path);

/// Returns decisions as such a CSV. Numbers are the shortest that read back equal.
std::string truthDecisionsCsv(const std::vector<TruthDecision>& decisions);

/// Returns Done if every decision belongs to a scene. Errors name the file and the line: there is no such row, or it
/// belongs to another run.
Status checkTruthDecisions(const LaserTruth& truth, const std::vector<TruthDecision>& decisions,
                           const std::string& path);

/// Applies decisions: heights of excluded scenes become unknown, those of nudged scenes move, and the slices of the
/// contact sheet with them. Scenes without a decision stay. Errors are those of checkTruthDecisions(); then nothing is
/// changed.
Status applyTruthDecisions(LaserTruth& truth, const std::vector<TruthDecision>& decisions,
                           const std::string& path);

}  // namespace terratact
