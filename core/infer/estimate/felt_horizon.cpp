#include "core/infer/estimate/felt_horizon.h"

#include <algorithm>

namespace terratact {

bool isTouchRecorded(const TerrainEstimate& estimate)
{
    return std::ranges::find(estimate.touch, Touch::Unrecorded) == estimate.touch.end();
}

int horizonBin(const TerrainEstimate& estimate)
{
    if (!isTouchRecorded(estimate)) return kBins - 1;
    int last = kFirstAhead - 1;
    for (int bin = kFirstAhead; bin < kBins; ++bin)
        if (isFeltThrough(estimate.touch[static_cast<std::size_t>(bin)])
            || binEnd(bin) <= estimate.feltTo + kHorizonSlack)
            last = bin;
    return last;
}

std::optional<double> feltHorizon(const TerrainEstimate& estimate)
{
    const int last = horizonBin(estimate);
    if (last < kFirstAhead || !isTouchRecorded(estimate)) return std::nullopt;
    return binEnd(last);
}

}  // namespace terratact
