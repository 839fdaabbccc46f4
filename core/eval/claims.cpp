#include "core/eval/claims.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

#include "core/infer/quantile.h"

namespace terratact {
namespace {

/// |errors| of one method in ascending order, each with the drive it belongs to.
struct SortedErrors {
    std::vector<double> size;
    std::vector<std::size_t> run;
};

/// Median when an error of drive r counts weight[r] times, `total` times over all; 0 for no errors.
double weightedMedian(const SortedErrors& errors, const std::vector<std::size_t>& weight,
                      std::size_t total)
{
    const std::size_t lower = (total - 1) / 2;
    const std::size_t upper = total / 2;
    double atLower = 0.0;
    std::size_t seen = 0;
    for (std::size_t i = 0; i < errors.size.size(); ++i) {
        const std::size_t before = seen;
        seen += weight[errors.run[i]];
        if (before <= lower && lower < seen) atLower = errors.size[i];
        if (before <= upper && upper < seen) return 0.5 * (atLower + errors.size[i]);
    }
    return atLower;
}

/// The errors of both methods in the bins that both estimated.
struct Comparison {
    SortedErrors base, better;
    std::vector<std::size_t> ofRun;  ///< errors per drive

    std::size_t total(const std::vector<std::size_t>& weight) const
    {
        std::size_t sum = 0;
        for (std::size_t r = 0; r < ofRun.size(); ++r) sum += weight[r] * ofRun[r];
        return sum;
    }
};

using ByPlace = std::map<std::pair<std::size_t, int>, double>;  // (scene, bin) → |error|

ByPlace errorsOf(Method method, const Claim& claim, std::span<const BinError> errors)
{
    ByPlace found;
    for (const BinError& e : errors)
        if (e.method == method && e.bin >= claim.firstBin && e.bin <= claim.lastBin)
            found[{e.scene, e.bin}] = std::abs(e.error);
    return found;
}

SortedErrors sorted(std::vector<std::pair<double, std::size_t>> sizeAndRun)
{
    std::sort(sizeAndRun.begin(), sizeAndRun.end());
    SortedErrors result;
    for (const auto& [size, run] : sizeAndRun) {
        result.size.push_back(size);
        result.run.push_back(run);
    }
    return result;
}

Comparison compare(const Claim& claim, std::span<const BinError> errors,
                   std::span<const Scene> scenes)
{
    const ByPlace base = errorsOf(claim.base, claim, errors);
    const ByPlace better = errorsOf(claim.better, claim, errors);
    std::vector<std::pair<double, std::size_t>> ofBase, ofBetter;
    std::map<std::string_view, std::size_t> runs;
    Comparison comparison;
    for (const auto& [place, size] : base) {
        const auto other = better.find(place);
        if (other == better.end()) continue;
        if (place.first >= scenes.size())
            throw std::invalid_argument("judge: an error of a scene that is not there");
        const std::size_t run =
            runs.try_emplace(scenes[place.first].run, runs.size()).first->second;
        ofBase.emplace_back(size, run);
        ofBetter.emplace_back(other->second, run);
        comparison.ofRun.resize(runs.size());
        ++comparison.ofRun[run];
    }
    comparison.base = sorted(std::move(ofBase));
    comparison.better = sorted(std::move(ofBetter));
    return comparison;
}

/// Differences of the medians in samples of drives with replacement.
std::vector<double> bootstrap(const Comparison& comparison, std::uint64_t seed, int resamples)
{
    std::mt19937_64 rng(seed);
    const std::size_t runs = comparison.ofRun.size();
    std::vector<double> differences;
    for (int k = 0; k < resamples; ++k) {
        std::vector<std::size_t> weight(runs, 0);
        for (std::size_t r = 0; r < runs; ++r) ++weight[rng() % runs];
        const std::size_t total = comparison.total(weight);
        differences.push_back(weightedMedian(comparison.better, weight, total)
                              - weightedMedian(comparison.base, weight, total));
    }
    return differences;
}

}  // namespace

std::string_view name(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Holds: return "holds";
    case Verdict::DoesNotHold: return "does not hold";
    case Verdict::NotDecided: return "not decided";
    }
    throw std::invalid_argument("name: no such Verdict");
}

ClaimResult judge(const Claim& claim, std::span<const BinError> errors,
                  std::span<const Scene> scenes, std::uint64_t seed, int resamples)
{
    if (resamples < 1) throw std::invalid_argument("judge: at least one resample");
    const Comparison comparison = compare(claim, errors, scenes);
    ClaimResult result{
        .claim = claim, .n = comparison.base.size.size(), .runs = comparison.ofRun.size()};
    const std::vector<std::size_t> once(result.runs, 1);
    result.baseMedian = weightedMedian(comparison.base, once, result.n);
    result.betterMedian = weightedMedian(comparison.better, once, result.n);
    if (result.runs < kLeastRuns) return result;

    const std::vector<double> differences = bootstrap(comparison, seed, resamples);
    result.low = quantile(differences, 0.025);
    result.high = quantile(differences, 0.975);
    if (result.high < 0.0) result.verdict = Verdict::Holds;
    if (result.low > 0.0) result.verdict = Verdict::DoesNotHold;
    return result;
}

}  // namespace terratact
