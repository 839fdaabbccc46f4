#pragma once

#include "core/infer/estimate/estimate.h"

namespace terratact {

/// Error of an estimate against true heights.
struct EstimateError {
    double rms = 0.0;      ///< [m] √(mean over the bins of (height − truth)²)
    double largest = 0.0;  ///< [m] largest |height − truth|
    int bin = 0;           ///< where it is
    int inBand = 0;        ///< bins whose truth lies within q10 … q90, of kBins
    bool operator==(const EstimateError&) const = default;
};

/// truth: [m], the line of the estimate's profile.
EstimateError errorAgainst(const TerrainEstimate& estimate, const Heights& truth);

}  // namespace terratact
