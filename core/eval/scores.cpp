#include "core/eval/scores.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/base/normal.h"
#include "core/infer/estimate/quantile.h"

namespace terratact {
namespace {

constexpr double kHalfOf50 = 0.6744897501960817;  // Φ⁻¹(0.75)
constexpr double kHalfOf80 = 1.2815515655446004;  // Φ⁻¹(0.9)
constexpr double kHalfOf95 = 1.9599639845400545;  // Φ⁻¹(0.975)

std::vector<double> sortedDraws(const TerrainEstimate& estimate, std::size_t bin)
{
    std::vector<double> values;
    values.reserve(estimate.draws.size());
    for (const Heights& h : estimate.draws) values.push_back(h[bin]);
    std::sort(values.begin(), values.end());
    return values;
}

/// Returns sorted draws of a measurement with this sd. The errors are quantiles of N(0, sd²). The golden ratio spreads
/// them over the draws, so that every stretch of draws gets all of them.
std::vector<double> measured(std::vector<double> sorted, double sd)
{
    constexpr double kGolden = 0.6180339887498949;
    const auto n = static_cast<double>(sorted.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double turn = (static_cast<double>(i) + 0.5) * kGolden;
        const double share = (std::floor((turn - std::floor(turn)) * n) + 0.5) / n;
        sorted[i] += sd * normalQuantile(share);
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

bool within(double low, double truth, double high)
{
    return low <= truth && truth <= high;
}

/// Returns true if the truth lies within q10 … q90 of a forecast without draws. Both ends are moved by the truth's sd.
bool withinMeasuredBand(const TerrainEstimate& estimate, std::size_t bin, double truth,
                        double truthSd)
{
    const double own = kHalfOf80 * truthSd;
    const double mean = estimate.mean[bin];
    return within(mean - std::hypot(mean - estimate.q10[bin], own), truth,
                  mean + std::hypot(estimate.q90[bin] - mean, own));
}

void scoreNormal(double mean, double sd, double truth, ForecastScores& scores)
{
    const double error = truth - mean;
    scores.crps = crpsOfNormal(mean, sd, truth);
    if (sd > 0.0)
        scores.pit = normalCdf(error / sd);
    else
        scores.pit = error == 0.0 ? 0.5 : error > 0.0 ? 1.0 : 0.0;
    scores.in50 = std::abs(error) <= kHalfOf50 * sd;
    scores.in95 = std::abs(error) <= kHalfOf95 * sd;
}

void scoreDraws(const std::vector<double>& sorted, double truth, ForecastScores& scores)
{
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), truth);
    const auto below = static_cast<double>(first - sorted.begin());
    const auto equal = static_cast<double>(last - first);
    scores.crps = crpsOfDraws(sorted, truth);
    scores.pit = (below + 0.5 * equal + 0.5) / (static_cast<double>(sorted.size()) + 1.0);
    scores.in50 = within(quantile(sorted, 0.25), truth, quantile(sorted, 0.75));
    scores.in95 = within(quantile(sorted, 0.025), truth, quantile(sorted, 0.975));
}

}  // namespace

double crpsOfDraws(std::span<const double> sorted, double truth)
{
    if (sorted.empty()) throw std::invalid_argument("crpsOfDraws: no draws");
    const auto n = static_cast<double>(sorted.size());
    double distance = 0.0;
    double spread = 0.0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        distance += std::abs(sorted[i] - truth);
        // Values relative to the truth: large numbers do not cancel.
        spread += (2.0 * static_cast<double>(i) + 1.0 - n) * (sorted[i] - truth);
    }
    return distance / n - spread / (n * n);
}

double crpsOfNormal(double mean, double sd, double truth)
{
    if (!(sd >= 0.0)) throw std::invalid_argument("crpsOfNormal: sd must be 0 or more");
    if (sd == 0.0) return std::abs(truth - mean);
    const double z = (truth - mean) / sd;
    const double density = std::exp(-0.5 * z * z) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
    return sd * (z * (2.0 * normalCdf(z) - 1.0) + 2.0 * density - std::numbers::inv_sqrtpi);
}

ForecastScores forecastScores(const TerrainEstimate& estimate, int bin, double truth,
                              double truthSd)
{
    if (bin < 0 || bin >= kBins)
        throw std::invalid_argument("forecastScores: bins are numbered 0 to 10");
    if (!(truthSd >= 0.0))
        throw std::invalid_argument("forecastScores: the truth's sd must be 0 or more");
    const auto i = static_cast<std::size_t>(bin);
    ForecastScores scores;
    scores.in80 = within(estimate.q10[i], truth, estimate.q90[i]);
    scores.width = estimate.q90[i] - estimate.q10[i];
    std::vector<double> draws = sortedDraws(estimate, i);
    if (draws.empty() || draws.front() == draws.back()) {
        scoreNormal(estimate.mean[i], std::hypot(estimate.sd[i], truthSd), truth, scores);
        if (truthSd > 0.0) scores.in80 = withinMeasuredBand(estimate, i, truth, truthSd);
        return scores;
    }
    if (truthSd > 0.0) {
        draws = measured(std::move(draws), truthSd);
        scores.in80 = within(quantile(draws, 0.1), truth, quantile(draws, 0.9));
    }
    scoreDraws(draws, truth, scores);
    return scores;
}

}  // namespace terratact
