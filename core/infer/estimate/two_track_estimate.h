#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/infer/estimate/estimate.h"
#include "core/robot/probe_side.h"

namespace terratact {

/// Estimate of both sides of a robot with two tracks.
struct TwoTrackEstimate {
    /// Left, right. Bins −0.3 … 0.2 m lie on the track's line, bins from 0.3 m on the flippers' line
    /// (core/terrain/ground_lines.h). Draw k of both sides is one joint draw.
    std::array<TerrainEstimate, 2> side;
    /// True if the scene was estimated as one plane: both sides are then equal. estimateMeasured()
    /// decides it (core/infer/two_track_estimator.h), mostly by isSymmetric() (core/robot/side_plane.h).
    bool onePlane = false;
    bool operator==(const TwoTrackEstimate&) const = default;
};

/// Returns the side's estimate. The middle has no own estimate: one plane has equal sides.
inline const TerrainEstimate& sideOf(const TwoTrackEstimate& estimate, ProbeSide side)
{
    return estimate.side[side == ProbeSide::Right ? 1 : 0];
}

/// Returns the estimate of one plane for both sides.
inline TwoTrackEstimate equalSides(TerrainEstimate plane)
{
    TwoTrackEstimate estimate{.side = {std::move(plane), {}}, .onePlane = true};
    estimate.side[1] = estimate.side[0];
    return estimate;
}

/// Returns the sentences of both sides. A sentence that both have stays as it is. "left: …" or
/// "right: …" precedes one of a single side. Sentences of the left side come first.
std::vector<Message> ofBothSides(const std::vector<Message>& left,
                                 const std::vector<Message>& right);

}  // namespace terratact
