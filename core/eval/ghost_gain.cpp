#include "core/eval/ghost_gain.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace terratact {
namespace {

constexpr double kNominal = 0.8;

bool samePlaces(std::span<const BinError> a, std::span<const BinError> b)
{
    return std::ranges::equal(a, b, [](const BinError& x, const BinError& y) {
        return x.scene == y.scene && x.bin == y.bin;
    });
}

}  // namespace

bool PairedGain::helps() const
{
    const auto miss = [](const ErrorStatistics& s) { return std::abs(s.coverage - kNominal); };
    return intervals && intervals->mean.high < 0.0 && intervals->crps.high < 0.0
        && miss(after) <= miss(before) + kCoverageLoss;
}

PairedGain pairedGain(std::span<const BinError> before, std::span<const BinError> after,
                      std::span<const Scene> scenes, std::uint64_t seed, int resamples)
{
    if (!samePlaces(before, after))
        throw std::invalid_argument("pairedGain: not the same scenes and bins");
    const std::vector<std::size_t> driveOfScene = driveNumbers(scenes);
    for (const BinError& e : before)
        if (e.scene >= driveOfScene.size())
            throw std::invalid_argument("pairedGain: an error of a scene that is not there");
    PairedGain gain{.n = before.size(),
                    .drives = 0,
                    .before = statistics(before),
                    .after = statistics(after),
                    .intervals = {}};
    std::vector<std::size_t> drives;
    for (const BinError& e : before) drives.push_back(driveOfScene[e.scene]);
    std::ranges::sort(drives);
    drives.erase(std::unique(drives.begin(), drives.end()), drives.end());
    gain.drives = drives.size();
    if (gain.drives < kMinRuns) return gain;

    const auto interval = [&](const auto& number) {
        std::vector<std::pair<double, std::size_t>> change;
        for (std::size_t k = 0; k < before.size(); ++k) {
            const auto drive = std::ranges::lower_bound(drives, driveOfScene[before[k].scene]);
            change.emplace_back(number(after[k]) - number(before[k]),
                                static_cast<std::size_t>(drive - drives.begin()));
        }
        const ClusteredValues values(std::move(change));
        return interval95(
            bootstrapDrives(gain.drives, seed, resamples,
                            [&](const DriveWeights& weight) { return values.mean(weight); }));
    };
    gain.intervals = {.mean = interval([](const BinError& e) { return std::abs(e.error); }),
                      .crps = interval([](const BinError& e) { return e.scores.crps; }),
                      .coverage =
                          interval([](const BinError& e) { return e.scores.in80 ? 1.0 : 0.0; })};
    return gain;
}

}  // namespace terratact
