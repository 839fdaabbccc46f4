#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/learn/data/scene.h"

namespace terratact {

// Scenes of one drive overlap and count nearly as one, so drives are what is drawn again, not scenes.
// Source: Efron & Tibshirani (1993), ch. 8 and 13; Field & Welsh, J. R. Stat. Soc. B 69 (2007).

/// Below so many drives nothing is decided, and no interval is given.
inline constexpr std::size_t kMinRuns = 5;

/// How often each drive was drawn.
using DriveWeights = std::vector<std::size_t>;

/// The number of each scene's drive (Scene::run), 0, 1, … by first appearance.
std::vector<std::size_t> driveNumbers(std::span<const Scene> scenes);

/// Numbers that belong to drives, and their statistics when every drive counts `weight` times.
class ClusteredValues {
public:
    /// values: each with the number of its drive.
    explicit ClusteredValues(std::vector<std::pair<double, std::size_t>> values);

    std::size_t size() const { return sorted_.size(); }
    /// Drives are numbered 0 … drives() − 1; some may have no value.
    std::size_t drives() const { return sum_.size(); }

    /// 0 where no value counts.  weight: one per drive, else std::invalid_argument.
    double median(const DriveWeights& weight) const;
    double mean(const DriveWeights& weight) const;

private:
    void check(const DriveWeights& weight) const;

    std::vector<std::pair<double, std::size_t>> sorted_;  ///< by value
    std::vector<double> sum_;                             ///< of a drive's values
    std::vector<std::size_t> count_;
};

/// The statistic of `resamples` samples of as many drives, drawn with replacement.
/// Same drives and seed: the same samples.  Throws std::invalid_argument unless resamples ≥ 1.
std::vector<double> bootstrapDrives(std::size_t drives, std::uint64_t seed, int resamples,
                                    const std::function<double(const DriveWeights&)>& statistic);

struct Interval {
    double low = 0.0, high = 0.0;
    bool operator==(const Interval&) const = default;
};

/// Percentile interval: the 2.5 and 97.5 % quantiles.
Interval interval95(const std::vector<double>& values);

}  // namespace terratact
