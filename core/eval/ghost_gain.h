#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/eval/cluster_bootstrap.h"
#include "core/eval/evaluation.h"

namespace terratact {

/// What changes from `before` to `after`, two ways to estimate the same bins of the same scenes.
struct PairedGain {
    std::size_t n = 0, drives = 0;
    ErrorStatistics before, after;
    struct Intervals {
        Interval mean, crps;  ///< [m] of after − before
        Interval coverage;    ///< of after − before, 80 % band
    };
    std::optional<Intervals> intervals;  ///< 95 %; empty for fewer than kMinRuns drives

    /// Shown to help, in error and in coverage: both intervals of the errors lie below 0, and the coverage of the
    /// 80 % band is at most kCoverageLoss further from 0.8 than it was.
    bool helps() const;
};

inline constexpr double kCoverageLoss = 0.01;

/// Bootstrap over whole drives (cluster_bootstrap.h), each error beside the one of its scene and bin.
/// Throws std::invalid_argument unless both have the same scenes and bins in the same order, and where an error's
/// scene is not among the scenes.
PairedGain pairedGain(std::span<const BinError> before, std::span<const BinError> after,
                      std::span<const Scene> scenes, std::uint64_t seed, int resamples = 2000);

}  // namespace terratact
