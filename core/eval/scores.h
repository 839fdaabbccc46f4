#pragma once

#include <span>

#include "core/infer/estimate/estimate.h"

namespace terratact {

/// Scores of one bin of one estimate as a forecast of its true height.
struct ForecastScores {
    /// Continuous ranked probability score [m]; |error| for a forecast without spread.
    double crps = 0.0;
    /// Probability integral transform: probability of a height below the truth; uniform if
    /// calibrated.
    double pit = 0.5;
    bool in50 = false;   ///< truth within the 25 and 75 % quantiles
    bool in80 = false;   ///< truth within q10 … q90
    bool in95 = false;   ///< truth within the 2.5 and 97.5 % quantiles
    double width = 0.0;  ///< [m] q90 − q10: sharpness
    bool operator==(const ForecastScores&) const = default;
};

/// Returns the CRPS of an empirical distribution: mean |xᵢ − y| − Σᵢ (2i − n − 1) x₍ᵢ₎ / n², i = 1
/// … n [m]. sorted: ascending, at least one value. Throws std::invalid_argument otherwise. Source:
/// Gneiting & Raftery, J. Am. Stat. Assoc. 102 (2007), eq. 21, with the second mean over ordered
/// draws.
double crpsOfDraws(std::span<const double> sorted, double truth);

/// Returns the CRPS of N(mean, sd²): sd [z (2Φ(z) − 1) + 2φ(z) − 1/√π], z = (y − mean) / sd  [m];
/// |y − mean| for sd 0. Throws std::invalid_argument unless sd ≥ 0. Source: Gneiting & Raftery (2007),
/// p. 367.
double crpsOfNormal(double mean, double sd, double truth);

/// Returns the scores of a bin from the estimate's draws. If there are none, or if all are equal as
/// in a fixed bin, the forecast is N(mean, sd²).
/// PIT of n draws: (r + ½) / (n + 1), with r draws below the truth; draws equal to the truth count
/// half. PIT of a forecast with sd 0: 0, ½ or 1. The 80 % band is q10 … q90, as the operator sees
/// it.
/// truth: [m]. truthSd: of a truth that is itself measured [m]. Bands, CRPS and PIT are then those of the forecast of
/// what the measurement reads: each draw has its part of N(0, truthSd²) added, and a normal forecast its variance.
/// `width` stays that of the operator's band. Throws std::invalid_argument unless 0 ≤ bin ≤ 10 and truthSd ≥ 0.
ForecastScores forecastScores(const TerrainEstimate& estimate, int bin, double truth,
                              double truthSd = 0.0);

}  // namespace terratact
