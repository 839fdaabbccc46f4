#pragma once

#include <cstddef>
#include <span>

#include "core/eval/contact_sd.h"
#include "core/learn/data/probe_file.h"

namespace terratact {

/// Standard deviation [m] with its 95 % interval, from `freedom` degrees of freedom; all 0 without
/// any.
struct SdEstimate {
    double sd = 0.0, low = 0.0, high = 0.0;
    std::size_t freedom = 0;
    bool operator==(const SdEstimate&) const = default;
};

/// Accuracy of the arm's height measurements.
struct ProbeAccuracy {
    std::size_t readings = 0, places = 0;
    SdEstimate repeated;           ///< around the mean of each place
    ResidualStatistics fromTruth;  ///< truth − reading, if the truth is known
};

/// Returns the accuracy. repeated: s² = Σ (x − mean of its place)² / ν with ν = readings − places,
/// and
///   s √(ν / χ²_ν,0.975) … s √(ν / χ²_ν,0.025)   (errors are assumed normal).
/// Repetitions at one place cannot show an error that is the same each time; fromTruth can.
ProbeAccuracy probeAccuracy(std::span<const ProbeReading> readings);

/// Returns the sd [m] of a reading: around the truth if at least two readings have it, else
/// repeated; 0 if neither is known.
double readingSd(const ProbeAccuracy& accuracy);

}  // namespace terratact
