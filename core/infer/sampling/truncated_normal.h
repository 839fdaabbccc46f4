#pragma once

#include <cstdint>
#include <functional>
#include <random>

namespace terratact {

/// Largest number of proposals for one draw.
inline constexpr int kMaxProposals = 1000;

/// Draws one bin height from N(mean, sigma²) cut off above `ceiling`:
///   p(h) ∝ exp(-(h - mean)² / 2σ²) for h ≤ ceiling, and 0 above it.
///
/// mean, ceiling, result: bin height [m] in the DEM frame, z up.  sigma: [m].
/// ceiling may be +infinity (no body above the bin: a plain normal draw). The result is finite and
/// never above the ceiling, even if the ceiling lies many deviations from the mean.
///
/// The same generator state gives the same draw with every standard library. Uniforms are the upper
/// 53 bits of one number of the generator. Gaussians use Marsaglia's polar method and discard the
/// second of a pair, so that nothing is kept between calls. Exponentials are −log u.
///
/// Effort: every proposal takes two numbers of the generator and is accepted with probability ≥
/// 0.38. More than n numbers are used with probability ≤ 0.62^⌊n/2⌋ (n = 100: 5e-11). After
/// kMaxProposals the last proposal is taken, moved inside the bounds. Only a broken generator
/// reaches that limit (0.62^1000 = 1e-208).
///
/// Throws std::invalid_argument unless sigma > 0, mean and sigma are finite, ceiling > −infinity.
/// Source: Robert, "Simulation of truncated normal variables", Stat. Comput. 5 (1995); the ceiling is the
/// kinematic constraint of Šalanský et al. §4.3.
double drawBelow(double ceiling, double mean, double sigma, std::mt19937_64& rng);

/// Draws from the normal distribution cut off on both sides: p(h) ∝ exp(-(h - mean)² / 2σ²) for
/// floor ≤ h ≤ ceiling. floor may be −infinity, which equals drawBelow. ceiling may be +infinity.
/// floor = ceiling returns that value. The mirrored problem (−ceiling, −floor, −mean) gives the
/// negative of the same draw. The exception is bounds equally far from the mean in double, such as
/// two infinite ones. Both problems are then drawn from the same side, and only the distribution is
/// mirrored. Throws std::invalid_argument as drawBelow, and unless floor ≤ ceiling, floor <
/// +infinity.
double drawBetween(double floor, double ceiling, double mean, double sigma, std::mt19937_64& rng);

/// Draws the same from any source of 64 random bits.
double drawBetween(double floor, double ceiling, double mean, double sigma,
                   const std::function<std::uint64_t()>& bits);

}  // namespace terratact
