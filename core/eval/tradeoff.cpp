#include "core/eval/tradeoff.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

namespace terratact {
namespace {

Settings wholeBudget(Method method, std::uint64_t seed)
{
    Settings settings;
    settings.method = method;
    settings.seed = seed;
    settings.stopEarly = false;
    settings.hazardRate = 0.0;  // the methods' own bands are compared
    return settings;
}

void addSampling(std::vector<TradeSetting>& all, const Settings& base)
{
    for (const int chains : {1, 4, 8, 32, 64}) {
        all.push_back({"chains", base, {}});
        all.back().settings.chains = chains;
    }
    for (const int rows : {88, 175, 350, 700}) {
        all.push_back({"inducing", base, {}});
        all.back().settings.inducing = rows;
    }
    all.push_back({"precision", base, {}});
    all.back().settings.precision = Precision::Double;
    all.push_back({"early stop", base, {}});
    all.back().settings.draws = 4000;
    all.back().settings.stopEarly = true;
}

}  // namespace

std::vector<TradeSetting> tradeSettings(Method method, std::uint64_t seed)
{
    const Settings base = wholeBudget(method, seed);
    std::vector<TradeSetting> all;
    all.reserve(20);
    for (const QualityPreset preset : kQualityPresets) {
        all.push_back({std::string(name(preset)), withPreset(base, preset), preset});
        all.back().settings.stopEarly = Settings{}.stopEarly;
    }
    for (const int draws : {125, 250, 500, 1000, 2000, 4000}) {
        all.push_back({"draws", base, {}});
        all.back().settings.draws = draws;
    }
    if (!isClosedForm(method)) addSampling(all, base);
    return all;
}

Settings referenceSettings(Method method, int draws, std::uint64_t seed)
{
    Settings settings = wholeBudget(method, seed);
    settings.draws = draws;
    settings.chains = 16;  // few and long: R-hat needs long chains
    settings.burnIn = 500;
    settings.precision = Precision::Double;
    return settings;
}

int leastReferenceDraws(std::span<const TradePoint> points)
{
    int most = 0;
    for (const TradePoint& point : points) most = std::max(most, point.draws);
    return 4 * most;
}

void ReferenceQuality::add(const TerrainEstimate& estimate)
{
    method = estimate.settings.method;
    const bool first = draws == 0;
    draws = std::max(draws, static_cast<int>(estimate.draws.size()));
    const double least = *std::min_element(estimate.ess.begin(), estimate.ess.end());
    ess = first ? least : std::min(ess, least);
    rhat = std::max(rhat, *std::max_element(estimate.rhat.begin(), estimate.rhat.end()));
    double own = 0.0;
    for (std::size_t i = 0; i < kBins; ++i) own += estimate.sd[i] / std::sqrt(estimate.ess[i]);
    error += (own / kBins - error) / ++scenes;
}

EstimateDistance distance(const TerrainEstimate& a, const TerrainEstimate& b)
{
    EstimateDistance sum;
    for (std::size_t i = 0; i < kBins; ++i) {
        sum.mean += std::abs(a.mean[i] - b.mean[i]);
        sum.quantile += 0.5 * (std::abs(a.q10[i] - b.q10[i]) + std::abs(a.q90[i] - b.q90[i]));
    }
    return {sum.mean / kBins, sum.quantile / kBins};
}

std::vector<bool> paretoFront(std::span<const double> cost, std::span<const double> error)
{
    if (cost.size() != error.size())
        throw std::invalid_argument("a Pareto front needs one cost and one error per point");
    std::vector<std::size_t> order(cost.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return cost[a] != cost[b] ? cost[a] < cost[b] : error[a] < error[b];
    });
    std::vector<bool> front(cost.size(), false);
    const double* least = nullptr;
    for (const std::size_t k : order) {
        if (least && !(error[k] < *least)) continue;
        front[k] = true;
        least = &error[k];
    }
    return front;
}

TradeFronts tradeFronts(std::span<const TradePoint> points)
{
    std::vector<double> cost, error;
    std::map<Method, std::vector<std::size_t>> sampled;
    for (std::size_t k = 0; k < points.size(); ++k) {
        cost.push_back(points[k].seconds);
        error.push_back(points[k].error);
        const Method method = points[k].setting.settings.method;
        if (!isClosedForm(method)) sampled[method].push_back(k);
    }
    TradeFronts fronts{std::vector<bool>(points.size(), false), paretoFront(cost, error)};
    for (const auto& [method, own] : sampled) {
        std::vector<double> ownCost, off;
        for (const std::size_t k : own) {
            ownCost.push_back(points[k].seconds);
            off.push_back(points[k].reference.quantile);
        }
        const std::vector<bool> front = paretoFront(ownCost, off);
        for (std::size_t n = 0; n < own.size(); ++n) fronts.reference[own[n]] = front[n];
    }
    return fronts;
}

}  // namespace terratact
