#include "tests/support/distributions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace terratact {

double kolmogorov(std::vector<double> sample, const std::function<double(double)>& cdf)
{
    std::sort(sample.begin(), sample.end());
    const double n = static_cast<double>(sample.size());
    double distance = 0.0;
    for (std::size_t i = 0; i < sample.size(); ++i) {
        const double f = cdf(sample[i]);
        distance = std::max(
            {distance, f - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - f});
    }
    return std::sqrt(n) * distance;
}

double millsRatio(double x)
{
    if (x < 5.0)
        return std::sqrt(0.5 * std::numbers::pi) * std::exp(0.5 * x * x)
             * std::erfc(x / std::numbers::sqrt2);
    // Evaluates Laplace's continued fraction 1/(x + 1/(x + 2/(x + 3/(x + …)))) from the inside.
    double rest = x;
    for (int k = 200; k >= 1; --k) rest = x + k / rest;
    return 1.0 / rest;
}

std::function<double(double)> truncatedCdf(double ceiling, double mean, double sigma)
{
    if (mean <= ceiling) {
        const auto phi = [](double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); };
        return [=](double h) {
            return std::min(1.0, phi((h - mean) / sigma) / phi((ceiling - mean) / sigma));
        };
    }
    // P(h) = Q(a + δ) / Q(a). a and a + δ are deviations of ceiling and h below the mean; Q(x) = φ(x) M(x).
    const double a = (mean - ceiling) / sigma;
    return [=](double h) {
        const double delta = std::max(0.0, (ceiling - h) / sigma);
        return std::exp(-delta * (a + 0.5 * delta)) * millsRatio(a + delta) / millsRatio(a);
    };
}

std::function<double(double)> truncatedCdf(double floor, double ceiling, double mean, double sigma)
{
    if (mean < floor) {  // mirrored, so that the tail keeps its digits
        const auto mirrored = truncatedCdf(-ceiling, -floor, -mean, sigma);
        return [mirrored](double h) { return 1.0 - mirrored(-h); };
    }
    const auto below = truncatedCdf(ceiling, mean, sigma);
    const double cut = below(floor);
    return [below, cut](double h) { return (below(h) - cut) / (1.0 - cut); };
}

}  // namespace terratact
