#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/eval/cluster_bootstrap.h"
#include "core/eval/evaluation.h"

namespace terratact {

/// Change from `before` to `after`, two estimates of the same bins of the same scenes.
struct PairedGain {
    std::size_t n = 0, drives = 0;
    ErrorStatistics before, after;
    struct Intervals {
        Interval mean, crps;  ///< after − before [m]
        Interval coverage;    ///< after − before, 80 % band
    };
    std::optional<Intervals> intervals;  ///< 95 %; empty for fewer than kMinRuns drives

    /// Returns true if `after` is shown to be better. Both intervals of the errors must lie below
    /// 0. The coverage of the 80 % band may be at most kCoverageLoss further from 0.8 than before.
    bool helps() const;
};

inline constexpr double kCoverageLoss = 0.01;

/// Bootstraps over whole drives (cluster_bootstrap.h), pairing the errors of each scene and bin.
/// Throws std::invalid_argument unless both have the same scenes and bins in the same order. It
/// also throws if an error's scene is not among the scenes.
PairedGain pairedGain(std::span<const BinError> before, std::span<const BinError> after,
                      std::span<const Scene> scenes, std::uint64_t seed, int resamples = 2000);

}  // namespace terratact
