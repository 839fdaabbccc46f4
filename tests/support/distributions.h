#pragma once

#include <functional>
#include <vector>

namespace terratact {

/// Kolmogorov–Smirnov statistic √n · sup |F_n − F| of a sample against a continuous distribution.
/// Above 2.23 with probability 1e-4, above 1.63 with probability 0.01 when the sample is from F.
double kolmogorov(std::vector<double> sample, const std::function<double(double)>& cdf);

/// Distribution function of N(mean, sigma²) cut off above `ceiling` (which may be +infinity), to 1e-12
/// of itself however far the ceiling lies below the mean.  Independent of the product's sampler.
std::function<double(double)> truncatedCdf(double ceiling, double mean, double sigma);

/// The same cut off below `floor`, too: floor ≤ ceiling, the interval no narrower than 1e-3 of the scale on which
/// the density changes (the difference of two distribution functions must keep its digits).
std::function<double(double)> truncatedCdf(double floor, double ceiling, double mean, double sigma);

/// Mills ratio (1 − Φ(x)) / φ(x) of the standard normal, x ≥ 0.
double millsRatio(double x);

}  // namespace terratact
