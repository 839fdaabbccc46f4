#include "app/modelling/truth/truth_errors.h"

#include <algorithm>
#include <cmath>

namespace terratact {

void TruthErrors::add(double error, double sd)
{
    constexpr double kBandSd = 1.2816;  // 80 % of a normal distribution
    ++bins;
    bias += error;
    meanError += std::abs(error);
    rms += error * error;
    worst = std::max(worst, std::abs(error));
    within += std::abs(error) <= kBandSd * sd ? 1.0 : 0.0;
}

void TruthErrors::finish()
{
    if (bins == 0) return;
    const auto n = static_cast<double>(bins);
    bias /= n;
    meanError /= n;
    within /= n;
    rms = std::sqrt(rms / n);
}

}  // namespace terratact
