#include "core/infer/sampling/draw_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/infer/estimate/quantile.h"
#include "core/infer/sampling/convergence.h"

namespace terratact {

namespace {

constexpr double kNormalQ90 = 1.2815515655446004;  // Φ⁻¹(0.9)

void judge(TerrainEstimate& estimate, const GibbsDraws& draws)
{
    double worstRhat = 1.0;
    double worstEss = std::numeric_limits<double>::infinity();
    for (const int bin : draws.bins) {
        worstRhat = std::max(worstRhat, estimate.rhat[static_cast<std::size_t>(bin)]);
        worstEss = std::min(worstEss, estimate.ess[static_cast<std::size_t>(bin)]);
    }
    if (draws.burnInLeftOut > 0)
        estimate.warnings.emplace_back(
            TR_NOOP("core", "time was out %1 sweeps before the burn-in's end: the draws depend on "
                            "where the chains started"),
            draws.burnInLeftOut);
    estimate.converged =
        worstRhat <= kRhatLimit && worstEss >= kEssLimit && draws.burnInLeftOut == 0;
    if (!estimate.converged)
        estimate.warnings.emplace_back(
            estimate.ending == Ending::Time
                ? TR_NOOP("core", "chains not converged when time was out: R-hat %1 (limit %2), "
                                  "effective draws %3 (limit %4)")
                : TR_NOOP("core", "chains not converged: R-hat %1 (limit %2), effective draws %3 "
                                  "(limit %4)"),
            rhatText(worstRhat), kRhatLimit, fixed(worstEss, 0), fixed(kEssLimit, 0));
}

/// Returns all draws in ascending order.
std::vector<double> sorted(const Eigen::MatrixXd& draws, const Poll& poll)
{
    PolledWork work(poll);
    std::vector<double> all;
    all.reserve(static_cast<std::size_t>(draws.size()));
    for (const double draw : draws.reshaped()) {
        work.done();
        all.push_back(draw);
    }
    std::sort(all.begin(), all.end(), [&work](double a, double b) {
        work.done();
        return a < b;
    });
    return all;
}

bool allFinite(const Heights& values)
{
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

void summariseDraws(TerrainEstimate& estimate, int bin, const Eigen::MatrixXd& draws, Origin origin,
                    Centre centre, const Poll& poll)
{
    const auto i = static_cast<std::size_t>(bin);
    callPoll(poll);
    const double mean = draws.mean();
    callPoll(poll);
    const std::vector<double> all = sorted(draws, poll);
    callPoll(poll);
    estimate.mean[i] = mean;
    estimate.height[i] = centre == Centre::Mean ? mean : quantileOfSorted(all, 0.5);
    estimate.sd[i] = std::sqrt((draws.array() - mean).square().mean());
    estimate.q10[i] = quantileOfSorted(all, 0.1);
    estimate.q90[i] = quantileOfSorted(all, 0.9);
    estimate.origin[i] = origin;
    callPoll(poll);
    RankedDraws ranked(draws, poll, estimate.ceiling[i]);
    estimate.rhat[i] = ranked.rhat();
    estimate.ess[i] = ranked.ess();
}

void fixBin(TerrainEstimate& estimate, int bin, const MeasuredHeight& measured)
{
    const auto i = static_cast<std::size_t>(bin);
    estimate.mean[i] = measured.height;
    estimate.height[i] = measured.height;
    estimate.sd[i] = measured.sd;
    estimate.q10[i] = measured.height - kNormalQ90 * measured.sd;
    estimate.q90[i] = measured.height + kNormalQ90 * measured.sd;
    estimate.origin[i] = measured.origin;
    estimate.rhat[i] = 1.0;
}

void warnIfMended(TerrainEstimate& estimate, int bin, const GaussianProcess& model)
{
    if (model.jitter() > 0.0)
        estimate.warnings.emplace_back(
            TR_NOOP("core",
                    "the model of bin %1 m is singular: %2 of its variance was added as noise"),
            signedFixed(binCentre(bin), 1), fmt::format("{:.0e}", model.jitter()));
}

std::vector<Heights> jointDraws(const GibbsDraws& draws, const OptionalHeights& known,
                                const Poll& poll)
{
    PolledWork work(poll);
    Heights start{};
    for (std::size_t i = 0; i < kBins; ++i) start[i] = known[i].value_or(0.0);
    const Eigen::Index count = draws.draws.empty() ? 1 : draws.draws.front().size();
    std::vector<Heights> all;
    all.reserve(static_cast<std::size_t>(count));
    for (Eigen::Index d = 0; d < count; ++d) {
        work.done(kBins);
        Heights& draw = all.emplace_back(start);
        for (std::size_t k = 0; k < draws.bins.size(); ++k)
            draw[static_cast<std::size_t>(draws.bins[k])] = draws.draws[k].data()[d];
    }
    return all;
}

void conclude(TerrainEstimate& estimate, const GibbsDraws& draws, const OptionalHeights& known,
              const Poll& poll)
{
    estimate.draws = jointDraws(draws, known, poll);
    estimate.ending = draws.ending;
    for (std::size_t i = 0; i < kBins; ++i)
        if (known[i]) estimate.ess[i] = static_cast<double>(estimate.draws.size());
    judge(estimate, draws);
}

TerrainEstimate finite(TerrainEstimate estimate, const Poll& poll)
{
    PolledWork work(poll);
    bool holds =
        std::isfinite(estimate.novelty)
        && std::all_of(estimate.draws.begin(), estimate.draws.end(), [&work](const Heights& h) {
               work.done(kBins);
               return allFinite(h);
           });
    for (const Heights& numbers : {estimate.mean, estimate.sd, estimate.q10, estimate.q90,
                                   estimate.height, estimate.rhat, estimate.ess})
        holds = holds && allFinite(numbers);
    if (!holds)
        throw RefusedInput(TR_NOOP("core", "the model gives no finite estimate of this scene"));
    return estimate;
}

}  // namespace terratact
