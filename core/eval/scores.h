#pragma once

#include <span>

#include "core/infer/estimate/estimate.h"

namespace terratact {

/// What one bin of one estimate is worth as a forecast, once the truth is known.
struct ForecastScores {
    double crps =
        0.0;  ///< [m] continuous ranked probability score; |error| for a forecast without spread
    double pit = 0.5;    ///< probability of a height below the truth; uniform where calibrated
    bool in50 = false;   ///< truth within the 25 and 75 % quantiles
    bool in80 = false;   ///< within q10 … q90
    bool in95 = false;   ///< within the 2.5 and 97.5 % quantiles
    double width = 0.0;  ///< [m] q90 − q10: sharpness
    bool operator==(const ForecastScores&) const = default;
};

/// CRPS of an empirical distribution: mean |xᵢ − y| − Σᵢ (2i − n − 1) x₍ᵢ₎ / n², i = 1 … n  [m].
/// sorted: ascending, at least one, else std::invalid_argument.
/// Source: Gneiting & Raftery, J. Am. Stat. Assoc. 102 (2007), eq. 21, the second mean over ordered draws.
double crpsOfDraws(std::span<const double> sorted, double truth);

/// CRPS of N(mean, sd²): sd [z (2Φ(z) − 1) + 2φ(z) − 1/√π], z = (y − mean) / sd  [m]; |y − mean| for sd 0.
/// Throws std::invalid_argument unless sd ≥ 0.  Source: the same, p. 367.
double crpsOfNormal(double mean, double sd, double truth);

/// Scores of a bin from the estimate's draws.  Where there are none, or all are equal (a bin fixed by a
/// contact or the arm), the forecast is N(mean, sd²).  PIT of n draws: (r + ½) / (n + 1), r of them below
/// the truth, those equal to it by half; of a forecast with sd 0: 0, ½ or 1.  The 80 % band is q10 … q90 as the operator sees it.
/// truth: [m].  Throws std::invalid_argument unless 0 ≤ bin ≤ 10.
ForecastScores forecastScores(const TerrainEstimate& estimate, int bin, double truth);

}  // namespace terratact
