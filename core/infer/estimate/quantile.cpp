#include "core/infer/estimate/quantile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace terratact {

double quantile(std::vector<double> values, double p)
{
    std::sort(values.begin(), values.end());
    return quantileOfSorted(values, p);
}

double quantileOfSorted(std::span<const double> sorted, double p)
{
    if (sorted.empty() || !(p >= 0.0 && p <= 1.0))
        throw std::invalid_argument("quantile of nothing, or p outside 0 … 1");
    const double place = p * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

}  // namespace terratact
