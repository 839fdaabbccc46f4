#include "core/strip/height_band.h"

#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

constexpr double kUpperTenth = 1.2815515655446004;  // Φ⁻¹(0.9)

double blend(double a, double b, double share)
{
    return (1.0 - share) * a + share * b;
}

/// Returns the mean by precision. `count`: how many independent heights the precisions add up to.
HeightBand weighted(const HeightBand& a, const HeightBand& b, double count)
{
    const double precisionA = 1.0 / (a.sd * a.sd), precisionB = 1.0 / (b.sd * b.sd);
    const double share = precisionB / (precisionA + precisionB);
    const double height = blend(a.height, b.height, share);
    const double sd = std::sqrt(count / (precisionA + precisionB));
    const double scale = sd / blend(a.sd, b.sd, share);
    return {height, sd, height - scale * blend(a.height - a.q10, b.height - b.q10, share),
            height + scale * blend(a.q90 - a.height, b.q90 - b.height, share)};
}

}  // namespace

HeightBand widened(const HeightBand& band, double w)
{
    return {band.height, std::hypot(band.sd, w),
            band.height - std::hypot(band.height - band.q10, kUpperTenth * w),
            band.height + std::hypot(band.q90 - band.height, kUpperTenth * w)};
}

HeightBand raised(const HeightBand& band, double up)
{
    return {band.height + up, band.sd, band.q10 + up, band.q90 + up};
}

HeightBand fused(const HeightBand& older, const HeightBand& newer, Fusion fusion)
{
    const bool isExact = !(older.sd > 0.0 && newer.sd > 0.0);
    switch (fusion) {
    case Fusion::FeltFirst:  // depends on more than the bands
    case Fusion::Newest: return newer;
    case Fusion::MoreCertain: return older.sd < newer.sd ? older : newer;
    case Fusion::Intersection:
    case Fusion::Independent:
        if (isExact) return older.sd < newer.sd ? older : newer;
        return weighted(older, newer, fusion == Fusion::Intersection ? 2.0 : 1.0);
    }
    throw std::invalid_argument("fused: no such Fusion");
}

}  // namespace terratact
