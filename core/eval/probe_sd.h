#pragma once

#include <cstddef>
#include <span>

#include "core/eval/contact_sd.h"
#include "core/learn/data/probe_file.h"

namespace terratact {

/// A standard deviation [m] with its 95 % interval, from `freedom` degrees of freedom; 0 … 0 without any.
struct SdEstimate {
    double sd = 0.0, low = 0.0, high = 0.0;
    std::size_t freedom = 0;
    bool operator==(const SdEstimate&) const = default;
};

/// How well the arm measures a height.
struct ProbeAccuracy {
    std::size_t readings = 0, places = 0;
    SdEstimate repeated;           ///< about the mean of each place
    ResidualStatistics fromTruth;  ///< truth − reading, where the truth is known
};

/// repeated: s² = Σ (x − mean of its place)² / ν with ν = readings − places, and
///   s √(ν / χ²_ν,0.975) … s √(ν / χ²_ν,0.025)   (errors are taken as normal).
/// Repeating the same place cannot show what the arm gets wrong there each time: fromTruth can.
ProbeAccuracy probeAccuracy(std::span<const ProbeReading> readings);

/// The sd [m] a reading should count with: about the truth where at least two readings know it, else repeated;
/// 0 where neither is known.
double readingSd(const ProbeAccuracy& accuracy);

}  // namespace terratact
