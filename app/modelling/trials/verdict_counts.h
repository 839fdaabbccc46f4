#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/infer/estimate/estimate.h"
#include "core/infer/verdict/verdict.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Verdict counts over a set of scenes.
struct VerdictCounts {
    std::size_t scenes = 0, failed = 0;
    /// Estimates that contradict their readings (core/sim/posterior_check.h): verdict withheld.
    std::size_t contradicting = 0;
    std::size_t withStep = 0;  ///< scenes with a true step ahead (bins kFirstAhead … 10)
    std::size_t clear = 0, blocked = 0;
    std::size_t falseClear = 0;                 ///< CLEAR with a true step before the felt horizon
    std::size_t overlooked = 0;                 ///< CLEAR with a true step beyond the felt horizon
    std::size_t flat = 0, flatClear = 0;        ///< isFlatTo() the front flippers' reach
    std::size_t pressed = 0, pressedClear = 0;  ///< of these: isPressedTo() that reach
    std::size_t feltBins = 0, feltCovered = 0;  ///< felt bins; those with truth in the 80 % band
    std::size_t unfeltBins = 0,
                unfeltCovered = 0;  ///< bins ahead not felt; those with truth in the 80 % band

    VerdictCounts& operator+=(const VerdictCounts& other);
};

/// Returns the last bin whose height a part of the robot limits, at least kMinHorizonBin: the front flippers' reach.
int reachOf(const TerrainEstimate& estimate);

/// Returns the last bin before the verdict's horizon.
int lastBinOf(const Verdict& verdict);

/// Counts one scene of one profile; pressed and pressedClear stay 0. stepLimit: [m].
VerdictCounts countVerdict(const Verdict& verdict, const TerrainEstimate& estimate,
                           const Heights& truth, double stepLimit);

/// Returns a line of a table of counts. kCountsHead is its head, kCountsLegend explains its columns.
std::string countsLine(std::string_view what, const VerdictCounts& counts);
extern const std::string_view kCountsHead, kCountsLegend;

}  // namespace terratact
