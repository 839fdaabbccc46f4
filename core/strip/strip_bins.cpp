#include "core/strip/strip_bins.h"

#include <algorithm>
#include <cmath>

#include "core/terrain/ground_lines.h"

namespace terratact {
namespace {

constexpr double kOnCentre = 1e-9;  // share of a bin's width
constexpr double kMajority = 0.9;   // share of a stretch that decides how it was felt

HeightBand bandOf(const TerrainEstimate& e, std::size_t i)
{
    return {e.height[i], e.sd[i], e.q10[i], e.q90[i]};
}

HeightBand blended(const HeightBand& a, const HeightBand& b, double share)
{
    const auto of = [share](double from, double to) { return (1.0 - share) * from + share * to; };
    const HeightBand band{of(a.height, b.height), of(a.sd, b.sd), of(a.q10, b.q10),
                          of(a.q90, b.q90)};
    return widened(band, std::abs(a.height - b.height) * share * (1.0 - share));
}

double slopeBefore(const TerrainEstimate& e, int bin)
{
    const auto i = static_cast<std::size_t>(std::clamp(bin, 1, kBins - 1));
    return (e.height[i] - e.height[i - 1]) / kBinWidth;
}

StripBin binAt(const TerrainEstimate& e, double position, std::int64_t source)
{
    const int rear = std::min(static_cast<int>(std::floor(position)), kBins - 2);
    const double share = position - rear;
    const auto i = static_cast<std::size_t>(rear);
    StripBin bin;
    bin.band = blended(bandOf(e, i), bandOf(e, i + 1), share);
    const FeltBy behind = feltBy(e, rear), ahead = feltBy(e, rear + 1);
    bin.felt = share >= kMajority       ? ahead
             : share <= 1.0 - kMajority ? behind
                                        : across(behind, ahead);
    const int nearest = share < 0.5 ? rear : rear + 1;
    bin.slopes = {slopeBefore(e, nearest), slopeBefore(e, nearest + 1)};
    bin.onFlipperLine = nearest >= kFirstFlipperBin;
    bin.source = source;
    return bin;
}

}  // namespace

std::vector<EnteredBin> binsOf(const TerrainEstimate& estimate, const Vec2& imu,
                               std::int64_t source)
{
    const auto first = static_cast<int>(std::ceil((imu.x + binCentre(0)) / kBinWidth - kOnCentre));
    std::vector<EnteredBin> bins;
    bins.reserve(kBins);
    for (int column = first; column < first + kBins; ++column) {
        const double position = column - (imu.x + binCentre(0)) / kBinWidth;
        if (position > kBins - 1 + kOnCentre) break;
        const double inside = std::clamp(position, 0.0, static_cast<double>(kBins - 1));
        StripBin bin = binAt(estimate, inside, source);
        bin.band = raised(bin.band, imu.z);
        bins.push_back({column, bin});
    }
    return bins;
}

}  // namespace terratact
