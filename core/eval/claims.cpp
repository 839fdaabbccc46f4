#include "core/eval/claims.h"

#include "core/base/named.h"
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace terratact {
namespace {

constexpr auto kClaimVerdictNames = namesOf<ClaimVerdict>("holds", "does not hold", "not decided");

using ByPlace = std::map<std::pair<std::size_t, int>, double>;  // (scene, bin) → |error|

ByPlace sizesOf(Method method, const Claim& claim, std::span<const BinError> errors)
{
    ByPlace found;
    for (const BinError& e : errors)
        if (e.label == name(method) && e.bin >= claim.firstBin && e.bin <= claim.lastBin)
            found[{e.scene, e.bin}] = std::abs(e.error);
    return found;
}

/// |errors| of both methods in the bins that both estimated. Drives without such bins do not count.
struct Comparison {
    ClusteredValues base, better;
};

Comparison compare(const Claim& claim, std::span<const BinError> errors,
                   std::span<const Scene> scenes)
{
    const ByPlace base = sizesOf(claim.base, claim, errors);
    const ByPlace better = sizesOf(claim.better, claim, errors);
    std::vector<std::pair<double, std::size_t>> ofBase, ofBetter;
    std::map<std::string_view, std::size_t> runs;
    for (const auto& [place, size] : base) {
        const auto other = better.find(place);
        if (other == better.end()) continue;
        if (place.first >= scenes.size())
            throw std::invalid_argument("judge: an error of a scene that is not there");
        const std::size_t run =
            runs.try_emplace(scenes[place.first].run, runs.size()).first->second;
        ofBase.emplace_back(size, run);
        ofBetter.emplace_back(other->second, run);
    }
    return {ClusteredValues(std::move(ofBase)), ClusteredValues(std::move(ofBetter))};
}

}  // namespace

std::string_view name(ClaimVerdict verdict)
{
    return nameIn(kClaimVerdictNames, verdict);
}

ClaimResult judge(const Claim& claim, std::span<const BinError> errors,
                  std::span<const Scene> scenes, std::uint64_t seed, int resamples)
{
    if (resamples < 1) throw std::invalid_argument("judge: at least one resample");
    const Comparison comparison = compare(claim, errors, scenes);
    ClaimResult result{
        .claim = claim, .n = comparison.base.size(), .runs = comparison.base.drives()};
    const DriveWeights once(result.runs, 1);
    result.baseMedian = comparison.base.median(once);
    result.betterMedian = comparison.better.median(once);
    if (result.runs < kMinRuns) return result;

    const auto difference = [&](const DriveWeights& weight) {
        return comparison.better.median(weight) - comparison.base.median(weight);
    };
    const Interval interval = interval95(bootstrapDrives(result.runs, seed, resamples, difference));
    result.low = interval.low;
    result.high = interval.high;
    if (result.high < 0.0) result.verdict = ClaimVerdict::Holds;
    if (result.low > 0.0) result.verdict = ClaimVerdict::DoesNotHold;
    return result;
}

}  // namespace terratact
