#include "core/infer/truncated_normal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace terratact {
namespace {

using Limits = std::numeric_limits<double>;

/// Beyond so many deviations a² would begin to cost digits and later overflow, while the tail is an
/// exponential to within 1e-12.
constexpr double kPlainExponential = 1e6;

/// Uniform on (0, 1): the midpoints of 2⁵³ equal cells, so that log is always finite.
double uniform(std::mt19937_64& rng)
{
    return (static_cast<double>(rng() >> 11U) + 0.5) * 0x1p-53;
}

double exponential(std::mt19937_64& rng)
{
    return -std::log(uniform(rng));
}

/// Marsaglia & Bray (1964): (u, v) uniform in the unit disc, u √(−2 ln r² / r²) is N(0, 1).
double gaussian(std::mt19937_64& rng)
{
    for (;;) {
        const double u = 2.0 * uniform(rng) - 1.0;
        const double v = 2.0 * uniform(rng) - 1.0;
        const double r2 = u * u + v * v;
        if (r2 < 1.0 && r2 > 0.0) return u * std::sqrt(-2.0 * std::log(r2) / r2);
    }
}

/// The mean lies at or below the ceiling: at least every second normal draw does, too.
double drawWithMeanBelow(double ceiling, double mean, double sigma, std::mt19937_64& rng)
{
    for (;;) {
        const double h = mean - sigma * gaussian(rng);
        if (h <= ceiling) return std::clamp(h, Limits::lowest(), Limits::max());
    }
}

/// How far, in deviations, a standard normal variable exceeds a, given that it does; a > 0.
/// Robert (1995), eq. 2.1 and 2.2: proposal a + Exp(λ) with λ = (a + √(a² + 4)) / 2, accepted with
/// probability exp(−(x − λ)² / 2) ≥ 0.76.  λ − a = 2 / (a + √(a² + 4)) keeps its digits for large a.
double drawExcess(double a, std::mt19937_64& rng)
{
    if (a > kPlainExponential) return exponential(rng) / a;
    const double root = std::sqrt(a * a + 4.0);
    const double lambda = 0.5 * (a + root);
    const double lambdaMinusA = 2.0 / (a + root);
    for (;;) {
        const double excess = exponential(rng) / lambda;
        const double d = excess - lambdaMinusA;
        if (2.0 * exponential(rng) >= d * d) return excess;
    }
}

void require(bool good, const char* text)
{
    if (!good) throw std::invalid_argument(text);
}

}  // namespace

double drawBelow(double ceiling, double mean, double sigma, std::mt19937_64& rng)
{
    require(std::isfinite(mean), "drawBelow: the mean must be finite");
    require(std::isfinite(sigma) && sigma > 0.0, "drawBelow: sigma must be finite and above 0");
    require(ceiling > -Limits::infinity(),
            "drawBelow: the ceiling must be a number above -infinity");
    if (mean <= ceiling) return drawWithMeanBelow(ceiling, mean, sigma, rng);

    // Halved, the difference of two finite numbers cannot overflow.  The excess is taken off the
    // ceiling, not off the mean: a thousandth of a deviation survives at a = 1e12.
    const double a = 2.0 * ((0.5 * mean - 0.5 * ceiling) / sigma);
    return std::max(ceiling - sigma * drawExcess(a, rng), Limits::lowest());
}

}  // namespace terratact
