#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/learn/data/scene.h"

namespace terratact {

// Cluster bootstrap over drives. Scenes of one drive overlap and count nearly as one, so whole
// drives are resampled. Source: Efron & Tibshirani (1993), ch. 8 and 13; Field & Welsh, J. R. Stat.
// Soc. B 69 (2007).

/// Least number of drives for a decision or an interval.
inline constexpr std::size_t kMinRuns = 5;

/// Number of times that each drive was drawn.
using DriveWeights = std::vector<std::size_t>;

/// Returns the number of each scene's drive (Scene::run): 0, 1, … by first appearance.
std::vector<std::size_t> driveNumbers(std::span<const Scene> scenes);

/// Values that belong to drives, and their statistics if every drive counts `weight` times.
class ClusteredValues {
public:
    /// values: each with the number of its drive.
    explicit ClusteredValues(std::vector<std::pair<double, std::size_t>> values);

    std::size_t size() const { return sorted_.size(); }
    /// Returns the number of drives, numbered from 0; some may have no value.
    std::size_t drives() const { return sum_.size(); }

    /// Return a statistic; 0 if no value counts. weight: one per drive. Throw std::invalid_argument
    /// otherwise.
    double median(const DriveWeights& weight) const;
    double mean(const DriveWeights& weight) const;

private:
    void check(const DriveWeights& weight) const;

    std::vector<std::pair<double, std::size_t>> sorted_;  ///< sorted by value
    std::vector<double> sum_;                             ///< sum of a drive's values
    std::vector<std::size_t> count_;
};

/// Returns the statistic of `resamples` samples of as many drives, drawn with replacement. The same
/// drives and seed give the same samples. Throws std::invalid_argument unless resamples ≥ 1.
std::vector<double> bootstrapDrives(std::size_t drives, std::uint64_t seed, int resamples,
                                    const std::function<double(const DriveWeights&)>& statistic);

struct Interval {
    double low = 0.0, high = 0.0;
    bool operator==(const Interval&) const = default;
};

/// Returns the percentile interval: the 2.5 and 97.5 % quantiles.
Interval interval95(const std::vector<double>& values);

}  // namespace terratact
