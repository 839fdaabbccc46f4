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

int lastFeltBin(const TerrainEstimate& estimate)
{
    if (!isTouchRecorded(estimate)) return kBins - 1;
    int bin = kFirstAhead;
    while (bin < kBins && isFeltThrough(estimate.touch[static_cast<std::size_t>(bin)])) ++bin;
    return bin - 1;
}

std::optional<double> feltHorizon(const TerrainEstimate& estimate)
{
    const int last = lastFeltBin(estimate);
    if (last < kFirstAhead || !isTouchRecorded(estimate)) return std::nullopt;
    return binEnd(last);
}

}  // namespace terratact
