#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/infer/estimate/two_track_estimate.h"
#include "core/log/rows/session_rows.h"

namespace terratact {

/// Profile of a recorded estimate, as exports and reports name it.
struct RecordedSide {
    std::string_view name;  ///< "both" for one plane, else "left" or "right"
    std::size_t index = 0;  ///< of TwoTrackEstimate::side
    /// True heights of the profile's line; empty: the source did not know them.
    std::optional<Heights> truth{};
};

/// Returns the profiles of an estimate: one of one plane, or those of the left and the right side.
/// scene: null if it is damaged.
std::vector<RecordedSide> recordedSides(bool onePlane, const SceneRow* scene);

}  // namespace terratact
