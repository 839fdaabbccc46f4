#include "core/eval/confidence.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace terratact {
namespace {

/// Errors of one label and their drives, numbered without gaps.
class Clusters {
public:
    Clusters(std::vector<BinError> errors, const std::vector<std::size_t>& driveOfScene)
        : errors_(std::move(errors))
    {
        for (const BinError& e : errors_) {
            if (e.scene >= driveOfScene.size())
                throw std::invalid_argument("confidence: an error of a scene that is not there");
            drive_.push_back(
                number_.try_emplace(driveOfScene[e.scene], number_.size()).first->second);
        }
    }
    std::size_t drives() const { return number_.size(); }

    template <class Number>
    ClusteredValues values(Number number, int lastBin = kBins - 1) const
    {
        std::vector<std::pair<double, std::size_t>> found;
        for (std::size_t k = 0; k < errors_.size(); ++k)
            if (errors_[k].bin <= lastBin) found.emplace_back(number(errors_[k]), drive_[k]);
        return ClusteredValues(std::move(found));
    }

private:
    std::vector<BinError> errors_;
    std::map<std::size_t, std::size_t> number_;
    std::vector<std::size_t> drive_;
};

ScoreIntervals intervalsOf(const Clusters& clusters, std::uint64_t seed, int resamples)
{
    const auto interval = [&](const auto& statistic) {
        return interval95(bootstrapDrives(clusters.drives(), seed, resamples, statistic));
    };
    const auto medianOf = [&](const ClusteredValues& values) {
        return interval([&](const DriveWeights& weight) { return values.median(weight); });
    };
    const auto meanOf = [&](const ClusteredValues& values) {
        return interval([&](const DriveWeights& weight) { return values.mean(weight); });
    };
    const auto size = [](const BinError& e) { return std::abs(e.error); };
    const ClusteredValues sizes = clusters.values(size);
    return {.median = medianOf(sizes),
            .mean = meanOf(sizes),
            .crps = meanOf(clusters.values([](const BinError& e) { return e.scores.crps; })),
            .coverage = meanOf(
                clusters.values([](const BinError& e) { return e.scores.in80 ? 1.0 : 0.0; })),
            .nearMedian = medianOf(clusters.values(size, kLastNearBin))};
}

}  // namespace

std::vector<Confidence> confidence(std::span<const BinError> errors, std::span<const Scene> scenes,
                                   std::uint64_t seed, int resamples)
{
    if (resamples < 1) throw std::invalid_argument("confidence: at least one resample");
    const std::vector<std::size_t> driveOfScene = driveNumbers(scenes);
    std::vector<Confidence> result;
    for (const std::string& label : labelsOf(errors)) {
        const Clusters clusters(errorsOf(label, errors), driveOfScene);
        Confidence own{.label = label, .drives = clusters.drives(), .intervals = {}};
        if (own.drives >= kMinRuns) own.intervals = intervalsOf(clusters, seed, resamples);
        result.push_back(std::move(own));
    }
    return result;
}

}  // namespace terratact
