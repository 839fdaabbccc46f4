#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/eval/cluster_bootstrap.h"
#include "core/eval/evaluation.h"

namespace terratact {

/// 95 % intervals of MethodSummary::all and ::near [m].
struct ScoreIntervals {
    Interval median, mean, crps, coverage;  ///< over all bins; coverage of the 80 % band
    Interval nearMedian;                    ///< over the bins up to kLastNearBin
};

struct Confidence {
    std::string label;
    std::size_t drives = 0;                   ///< drives with an estimate
    std::optional<ScoreIntervals> intervals;  ///< empty for fewer than kMinRuns drives
};

/// Bootstraps over the drives of each label's scenes; one entry per label in the order of labelsOf.
/// The same errors, scenes and seed give the same result. Throws std::invalid_argument if an
/// error's scene is not among the scenes, or resamples < 1.
std::vector<Confidence> confidence(std::span<const BinError> errors, std::span<const Scene> scenes,
                                   std::uint64_t seed, int resamples = 2000);

}  // namespace terratact
