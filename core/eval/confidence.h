#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/eval/cluster_bootstrap.h"
#include "core/eval/evaluation.h"

namespace terratact {

/// 95 % intervals of what MethodSummary::all and ::near say [m].
struct ScoreIntervals {
    Interval median, mean, crps, coverage;  ///< of all bins; coverage of the 80 % band
    Interval nearMedian;                    ///< of the bins up to kLastNearBin
};

struct Confidence {
    std::string label;
    std::size_t drives = 0;                   ///< with an estimate
    std::optional<ScoreIntervals> intervals;  ///< empty for fewer than kMinRuns drives
};

/// Bootstrap over the drives of each label's scenes, one entry per label in the order of labelsOf.
/// Same errors, scenes and seed: the same result.  Throws std::invalid_argument where an error's scene is
/// not among the scenes or resamples < 1.
std::vector<Confidence> confidence(std::span<const BinError> errors, std::span<const Scene> scenes,
                                   std::uint64_t seed, int resamples = 2000);

}  // namespace terratact
