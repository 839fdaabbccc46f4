#pragma once

#include <functional>
#include <vector>

namespace terratact {

/// Returns the Kolmogorov–Smirnov statistic √n · sup |F_n − F| of a sample against a continuous distribution. For a
/// sample from F it exceeds 2.23 with probability 1e-4, and 1.63 with probability 0.01.
double kolmogorov(std::vector<double> sample, const std::function<double(double)>& cdf);

/// Returns the distribution function of N(mean, sigma²) truncated above `ceiling` (may be +infinity). Its relative
/// error is 1e-12 however far the ceiling lies below the mean. It is independent of the product's sampler.
std::function<double(double)> truncatedCdf(double ceiling, double mean, double sigma);

/// Returns the distribution function truncated below `floor`, too. Needs floor ≤ ceiling, and an interval of at least
/// 1e-3 of the scale on which the density changes. Otherwise the difference of two distribution functions loses digits.
std::function<double(double)> truncatedCdf(double floor, double ceiling, double mean, double sigma);

/// Returns the Mills ratio (1 − Φ(x)) / φ(x) of the standard normal for x ≥ 0.
double millsRatio(double x);

}  // namespace terratact
