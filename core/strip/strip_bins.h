#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/strip/dead_reckoning.h"
#include "core/strip/felt_by.h"
#include "core/strip/height_band.h"

namespace terratact {

/// Ground of one bin of the strip, on one side.
struct StripBin {
    HeightBand band;  ///< [m] in the section's frame, with the sd at the time of touch
    /// Slopes of the estimate's ground before and behind the bin, for the effect of slip.
    std::array<double, 2> slopes{};
    FeltBy felt = FeltBy::Unrecorded;
    bool onFlipperLine = false;  ///< the line of the flippers, not of the track (ground_lines.h)
    std::int64_t source = 0;     ///< number of the StripSource
    bool operator==(const StripBin&) const = default;
};

/// A column of the strip that an estimate covers.
struct EnteredBin {
    int column = 0;  ///< its centre is at column · kBinWidth
    StripBin bin;
};

/// Returns the columns between the first and the last bin centre of an estimate. imu: [m] in the section's frame.
/// Heights and bands are interpolated linearly between two bins. That is exact where the ground of the two bins is
/// level. A step within a bin gives an error of up to a quarter of the two bins' difference. Therefore the sd grows by
/// |difference| · share · (1 − share).
std::vector<EnteredBin> binsOf(const TerrainEstimate& estimate, const Vec2& imu,
                               std::int64_t source);

}  // namespace terratact
