#include "core/eval/estimate_error.h"

#include <cmath>

namespace terratact {

EstimateError errorAgainst(const TerrainEstimate& estimate, const Heights& truth)
{
    EstimateError error;
    double squares = 0.0;
    for (std::size_t i = 0; i < kBins; ++i) {
        const double off = std::abs(estimate.height.at(i) - truth.at(i));
        squares += off * off;
        if (off > error.largest) {
            error.largest = off;
            error.bin = static_cast<int>(i);
        }
        if (estimate.q10.at(i) <= truth.at(i) && truth.at(i) <= estimate.q90.at(i)) ++error.inBand;
    }
    error.rms = std::sqrt(squares / kBins);
    return error;
}

}  // namespace terratact
