#include "core/eval/scores.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "core/infer/estimate/quantile.h"

namespace terratact {
namespace {

constexpr double kHalfOf50 = 0.6744897501960817;  // Φ⁻¹(0.75)
constexpr double kHalfOf95 = 1.9599639845400545;  // Φ⁻¹(0.975)

double normalCdf(double z)
{
    return 0.5 * std::erfc(-z * std::numbers::sqrt2 / 2.0);
}

std::vector<double> sortedDraws(const TerrainEstimate& estimate, std::size_t bin)
{
    std::vector<double> values;
    values.reserve(estimate.draws.size());
    for (const Heights& h : estimate.draws) values.push_back(h[bin]);
    std::sort(values.begin(), values.end());
    return values;
}

bool within(double low, double truth, double high)
{
    return low <= truth && truth <= high;
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

ForecastScores forecastScores(const TerrainEstimate& estimate, int bin, double truth)
{
    if (bin < 0 || bin >= kBins)
        throw std::invalid_argument("forecastScores: bins are numbered 0 to 10");
    const auto i = static_cast<std::size_t>(bin);
    ForecastScores scores;
    scores.in80 = within(estimate.q10[i], truth, estimate.q90[i]);
    scores.width = estimate.q90[i] - estimate.q10[i];
    const std::vector<double> draws = sortedDraws(estimate, i);
    if (draws.empty() || draws.front() == draws.back())
        scoreNormal(estimate.mean[i], estimate.sd[i], truth, scores);
    else
        scoreDraws(draws, truth, scores);
    return scores;
}

}  // namespace terratact
