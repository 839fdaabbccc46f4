#include "core/infer/sampling/truncated_normal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace terratact {
namespace {

using Limits = std::numeric_limits<double>;

/// Beyond this many deviations a² would lose digits and later overflow. The tail is then an
/// exponential to within 1e-12.
constexpr double kPlainExponential = 1e6;

/// An interval this wide [deviations] around the mean holds at least half of the normal draws. In a
/// narrower interval, at least half of the uniform draws lie under the density.
constexpr double kWide = 2.5;

/// Uniform on (0, 1], never 0: the midpoints of 2⁵³ equal cells, so that log is always finite.
template <class Bits>
double uniform(Bits& rng)
{
    return (static_cast<double>(rng() >> 11U) + 0.5) * 0x1p-53;
}

template <class Bits>
double exponential(Bits& rng)
{
    return -std::log(uniform(rng));
}

/// Marsaglia & Bray (1964): (u, v) uniform in the unit disc, u √(−2 ln r² / r²) is N(0, 1).
template <class Bits>
double gaussian(Bits& rng)
{
    double u = 0.0;
    for (int proposal = 0; proposal < kMaxProposals; ++proposal) {
        u = 2.0 * uniform(rng) - 1.0;
        const double v = 2.0 * uniform(rng) - 1.0;
        const double r2 = u * u + v * v;
        if (r2 < 1.0 && r2 > 0.0) return u * std::sqrt(-2.0 * std::log(r2) / r2);
    }
    return u;
}

/// Returns (a − b) / sigma. Halving first avoids overflow of the difference.
double deviations(double a, double b, double sigma)
{
    return 2.0 * ((0.5 * a - 0.5 * b) / sigma);
}

/// Bounds in a frame that makes the nearer bound the ceiling.
struct Interval {
    double floor, ceiling, mean, sigma;

    double width() const { return deviations(ceiling, floor, sigma); }
    double at(double share) const
    {
        return std::max(ceiling - 2.0 * (share * (0.5 * ceiling - 0.5 * floor)), floor);
    }
};

/// Draws where a wide interval holds the mean: at least every second normal draw lies in it.
template <class Bits>
double drawWideAroundMean(const Interval& i, Bits& rng)
{
    double h = i.mean;
    for (int proposal = 0; proposal < kMaxProposals; ++proposal) {
        h = i.mean - i.sigma * gaussian(rng);
        if (h <= i.ceiling && h >= i.floor) break;
    }
    return std::clamp(std::clamp(h, i.floor, i.ceiling), Limits::lowest(), Limits::max());
}

/// Draws where a narrow interval holds the mean: uniform, accepted with the density.
template <class Bits>
double drawNarrowAroundMean(const Interval& i, Bits& rng)
{
    double h = i.mean;
    for (int proposal = 0; proposal < kMaxProposals; ++proposal) {
        h = i.at(uniform(rng));
        const double z = deviations(h, i.mean, i.sigma);
        if (2.0 * exponential(rng) >= z * z) break;
    }
    return h;
}

/// Returns how far, in deviations, a standard normal variable exceeds a, given that it does; a > 0.
/// Source: Robert (1995), eq. 2.1 and 2.2. The proposal a + Exp(λ) with λ = (a + √(a² + 4)) / 2 is
/// accepted with probability exp(−(x − λ)² / 2) ≥ 0.76. λ − a = 2 / (a + √(a² + 4)) keeps its
/// digits for large a.
template <class Bits>
double drawExcess(double a, Bits& rng)
{
    if (a > kPlainExponential) return exponential(rng) / a;
    const double root = std::sqrt(a * a + 4.0);
    const double lambda = 0.5 * (a + root);
    const double lambdaMinusA = 2.0 / (a + root);
    double excess = 0.0;
    for (int proposal = 0; proposal < kMaxProposals; ++proposal) {
        excess = exponential(rng) / lambda;
        const double d = excess - lambdaMinusA;
        if (2.0 * exponential(rng) >= d * d) break;
    }
    return excess;
}

/// Returns the same excess, given that it is at most `width`, as a share of the width. The proposal
/// is an exponential of rate λ = a + m, cut off at the width, by inversion. It is accepted with
/// probability exp(−(x − m)² / 2). m = min(λ − a as above, width) keeps |x − m| ≤ 1 for the larger
/// part.
template <class Bits>
double drawShareOfExcess(double a, double width, Bits& rng)
{
    const bool plain = a > kPlainExponential;
    const double m = plain ? 0.0 : std::min(2.0 / (a + std::sqrt(a * a + 4.0)), width);
    const double fall = (a + m) * width;  // fall of the log density over the interval
    double share = 0.0;
    for (int proposal = 0; proposal < kMaxProposals; ++proposal) {
        const double u = uniform(rng);
        share = fall > 0.0 ? std::min(-std::log1p(u * std::expm1(-fall)) / fall, 1.0) : u;
        const double d = share * width - m;
        if (plain || 2.0 * exponential(rng) >= d * d) break;
    }
    return share;
}

/// Draws where the mean lies above the ceiling. The excess is subtracted from the ceiling, not from
/// the mean: a thousandth of a deviation survives 1e12 deviations away.
template <class Bits>
double drawBelowMean(const Interval& i, Bits& rng)
{
    const double a = deviations(i.mean, i.ceiling, i.sigma);
    const double width = i.width();
    if (std::isfinite(a * width) && width < kWide) return i.at(drawShareOfExcess(a, width, rng));
    double h = i.ceiling;
    for (int proposal = 0; proposal < kMaxProposals; ++proposal) {
        h = std::max(i.ceiling - i.sigma * drawExcess(a, rng), Limits::lowest());
        if (h >= i.floor) break;
    }
    return std::max(h, i.floor);
}

template <class Bits>
double draw(const Interval& i, Bits& rng)
{
    if (i.floor == i.ceiling) return i.floor;
    if (i.mean > i.ceiling) return drawBelowMean(i, rng);
    return i.width() < kWide ? drawNarrowAroundMean(i, rng) : drawWideAroundMean(i, rng);
}

void require(bool good, const char* text)
{
    if (!good) throw std::invalid_argument(text);
}

template <class Bits>
double drawInside(double floor, double ceiling, double mean, double sigma, Bits& rng)
{
    require(std::isfinite(mean), "a truncated normal's mean must be finite");
    require(std::isfinite(sigma) && sigma > 0.0,
            "a truncated normal's sigma must be finite and above 0");
    require(ceiling > -Limits::infinity(),
            "a truncated normal's ceiling must be a number above -infinity");
    require(floor <= ceiling && floor < Limits::infinity(),
            "a truncated normal's floor must be a number not above the ceiling");
    if (0.5 * mean - 0.5 * floor < 0.5 * ceiling - 0.5 * mean)
        return -draw({-ceiling, -floor, -mean, sigma}, rng);
    return draw({floor, ceiling, mean, sigma}, rng);
}

}  // namespace

double drawBelow(double ceiling, double mean, double sigma, std::mt19937_64& rng)
{
    return drawBetween(-Limits::infinity(), ceiling, mean, sigma, rng);
}

double drawBetween(double floor, double ceiling, double mean, double sigma, std::mt19937_64& rng)
{
    return drawInside(floor, ceiling, mean, sigma, rng);
}

double drawBetween(double floor, double ceiling, double mean, double sigma,
                   const std::function<std::uint64_t()>& bits)
{
    return drawInside(floor, ceiling, mean, sigma, bits);
}

}  // namespace terratact
