#include "core/eval/probes.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace terratact {
namespace {

double sizeOf(const TerrainEstimate& estimate, const Scene& scene, std::size_t bin)
{
    return std::abs(estimate.height[bin] - *scene.truth[bin]);
}

ProbeErrors errorsOf(const TerrainEstimate& estimate, const Scene& scene)
{
    ProbeErrors errors;
    for (const int bin : kBinsAhead)
        errors.ahead += sizeOf(estimate, scene, static_cast<std::size_t>(bin)) / kBinsAhead.size();
    int known = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
        if (!scene.truth[i]) continue;
        errors.all += sizeOf(estimate, scene, i);
        ++known;
    }
    errors.all /= known;
    return errors;
}

bool settled(const TerrainEstimate& estimate, double limit)
{
    return std::all_of(estimate.sd.begin(), estimate.sd.end(),
                       [limit](double sd) { return sd < limit; });
}

ArmReading readingOf(std::size_t sceneIndex, double truth, int bin, const ProbeLimits& limits)
{
    std::seed_seq seed{static_cast<std::uint32_t>(limits.seed),
                       static_cast<std::uint32_t>(limits.seed >> 32U),
                       static_cast<std::uint32_t>(sceneIndex), static_cast<std::uint32_t>(bin)};
    std::mt19937_64 rng(seed);
    return {bin, truth + std::normal_distribution<double>(0.0, limits.armSd)(rng), limits.armSd};
}

/// Returns the bin to touch; empty if the rule names none, one that was read before, or one without
/// truth.
std::optional<int> nextBin(const Scene& scene, const TerrainEstimate& estimate,
                           const std::vector<ArmReading>& readings, const ProbeRule& rule)
{
    const std::optional<int> bin = rule(estimate, readings);
    if (!bin || !scene.truth[static_cast<std::size_t>(*bin)]) return std::nullopt;
    const bool read = std::any_of(readings.begin(), readings.end(),
                                  [&](const ArmReading& r) { return r.bin == *bin; });
    return read ? std::nullopt : bin;
}

void add(ProbeErrors& sum, const ProbeErrors& errors, std::size_t count)
{
    sum.ahead += errors.ahead / static_cast<double>(count);
    sum.all += errors.all / static_cast<double>(count);
}

}  // namespace

bool hasTruthAhead(const Scene& scene)
{
    return std::all_of(kBinsAhead.begin(), kBinsAhead.end(), [&](int bin) {
        return scene.truth[static_cast<std::size_t>(bin)].has_value();
    });
}

ProbeTrial tryProbes(std::size_t sceneIndex, const Scene& scene, const TerrainEstimate& first,
                     const ProbeEstimator& estimate, const ProbeRule& rule,
                     const ProbeLimits& limits)
{
    if (!hasTruthAhead(scene) || !(limits.armSd > 0.0) || !(limits.sdLimit > 0.0)
        || limits.most < 1)
        throw std::invalid_argument("tryProbes: no truth ahead, or a limit out of range");
    ProbeTrial trial{.before = errorsOf(first, scene), .after = errorsOf(first, scene)};
    TerrainEstimate now = first;
    std::vector<ArmReading> readings;
    while (!settled(now, limits.sdLimit) && trial.probes < limits.most) {
        const std::optional<int> bin = nextBin(scene, now, readings, rule);
        if (!bin) break;
        readings.push_back(
            readingOf(sceneIndex, *scene.truth[static_cast<std::size_t>(*bin)], *bin, limits));
        now = estimate(scene, readings);
        if (++trial.probes == 1) trial.after = errorsOf(now, scene);
    }
    trial.settled = settled(now, limits.sdLimit);
    return trial;
}

ProbeSummary summariseProbes(const std::string& label, const std::string& rule,
                             std::span<const ProbeTrial> trials, const ProbeLimits& limits)
{
    ProbeSummary summary;
    summary.label = label;
    summary.rule = rule;
    summary.scenes = trials.size();
    for (const ProbeTrial& t : trials) summary.probed += t.probes > 0 ? 1 : 0;
    for (const ProbeTrial& t : trials) {
        add(summary.before, t.before, summary.scenes);
        add(summary.after, t.after, summary.scenes);
        summary.settled += t.settled ? 1 : 0;
        summary.probesNeeded += static_cast<double>(t.settled ? t.probes : limits.most)
                              / static_cast<double>(summary.scenes);
        if (t.probes == 0) continue;
        add(summary.beforeProbed, t.before, summary.probed);
        add(summary.afterProbed, t.after, summary.probed);
    }
    return summary;
}

}  // namespace terratact
