#include "core/eval/cluster_bootstrap.h"

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>
#include <string_view>

#include "core/infer/estimate/quantile.h"

namespace terratact {

std::vector<std::size_t> driveNumbers(std::span<const Scene> scenes)
{
    std::map<std::string_view, std::size_t> number;
    std::vector<std::size_t> result;
    result.reserve(scenes.size());
    for (const Scene& scene : scenes)
        result.push_back(number.try_emplace(scene.run, number.size()).first->second);
    return result;
}

ClusteredValues::ClusteredValues(std::vector<std::pair<double, std::size_t>> values)
    : sorted_(std::move(values))
{
    std::sort(sorted_.begin(), sorted_.end());
    for (const auto& [value, drive] : sorted_) {
        if (drive >= sum_.size()) {
            sum_.resize(drive + 1, 0.0);
            count_.resize(drive + 1, 0);
        }
        sum_[drive] += value;
        ++count_[drive];
    }
}

void ClusteredValues::check(const DriveWeights& weight) const
{
    if (weight.size() < drives())
        throw std::invalid_argument("ClusteredValues: a drive without a weight");
}

double ClusteredValues::median(const DriveWeights& weight) const
{
    check(weight);
    std::size_t total = 0;
    for (std::size_t d = 0; d < drives(); ++d) total += weight[d] * count_[d];
    if (total == 0) return 0.0;
    const std::size_t lower = (total - 1) / 2;
    const std::size_t upper = total / 2;
    double atLower = 0.0;
    std::size_t seen = 0;
    for (const auto& [value, drive] : sorted_) {
        const std::size_t before = seen;
        seen += weight[drive];
        if (before <= lower && lower < seen) atLower = value;
        if (before <= upper && upper < seen) return 0.5 * (atLower + value);
    }
    return atLower;
}

double ClusteredValues::mean(const DriveWeights& weight) const
{
    check(weight);
    double sum = 0.0;
    std::size_t total = 0;
    for (std::size_t d = 0; d < drives(); ++d) {
        sum += static_cast<double>(weight[d]) * sum_[d];
        total += weight[d] * count_[d];
    }
    return total == 0 ? 0.0 : sum / static_cast<double>(total);
}

std::vector<double> bootstrapDrives(std::size_t drives, std::uint64_t seed, int resamples,
                                    const std::function<double(const DriveWeights&)>& statistic)
{
    if (resamples < 1) throw std::invalid_argument("bootstrapDrives: at least one resample");
    std::mt19937_64 rng(seed);
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(resamples));
    DriveWeights weight(drives);
    for (int k = 0; k < resamples; ++k) {
        std::fill(weight.begin(), weight.end(), 0);
        for (std::size_t d = 0; d < drives; ++d) ++weight[rng() % drives];
        values.push_back(statistic(weight));
    }
    return values;
}

Interval interval95(const std::vector<double>& values)
{
    return {quantile(values, 0.025), quantile(values, 0.975)};
}

}  // namespace terratact
