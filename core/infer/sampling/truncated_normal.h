#pragma once

#include <cstdint>
#include <functional>
#include <random>

namespace terratact {

/// Of one draw.
inline constexpr int kMaxProposals = 1000;

/// Draws one bin height from N(mean, sigma²) cut off above `ceiling`:
///   p(h) ∝ exp(-(h - mean)² / 2σ²) for h ≤ ceiling, and 0 above it.
///
/// mean, ceiling, result: bin height [m] in the DEM frame, z up.  sigma: [m].
/// ceiling may be +infinity (no body above the bin: a plain normal draw).  The result is finite and never
/// above the ceiling, however many deviations the ceiling lies from the mean.
///
/// Same generator state, same draw with every standard library: uniforms are the upper 53 bits of one
/// number of the generator, Gaussians Marsaglia's polar method (the second of a pair is thrown away, so
/// nothing is kept between calls), exponentials −log u.
///
/// Effort: every proposal is accepted with probability ≥ 0.38, whatever the arguments, and takes two
/// numbers of the generator: more than n are used with probability ≤ 0.62^⌊n/2⌋ (n = 100: 5e-11).  After
/// kMaxProposals the last one is taken, moved inside the bounds: no generator but a broken one, and no
/// distribution, shows it (0.62^1000 = 1e-208), and a draw ends with every one.
///
/// Throws std::invalid_argument unless sigma > 0, mean and sigma are finite, ceiling > −infinity.
/// Source: Robert, "Simulation of truncated normal variables", Stat. Comput. 5 (1995); the ceiling is the
/// kinematic constraint of Šalanský et al. §4.3.
double drawBelow(double ceiling, double mean, double sigma, std::mt19937_64& rng);

/// The same cut off on both sides: p(h) ∝ exp(-(h - mean)² / 2σ²) for floor ≤ h ≤ ceiling.
/// floor may be −infinity (then this is drawBelow) and ceiling +infinity; floor = ceiling returns it.
/// The mirrored problem (−ceiling, −floor, −mean) gives the negative of the same draw, unless the bounds lie
/// equally far from the mean as far as double tells, two infinite ones among them: there both problems are drawn from
/// the same side, and only the distribution is mirrored.
/// Throws std::invalid_argument as drawBelow, and unless floor ≤ ceiling, floor < +infinity.
double drawBetween(double floor, double ceiling, double mean, double sigma, std::mt19937_64& rng);

/// The same from any source of 64 random bits.
double drawBetween(double floor, double ceiling, double mean, double sigma,
                   const std::function<std::uint64_t()>& bits);

}  // namespace terratact
