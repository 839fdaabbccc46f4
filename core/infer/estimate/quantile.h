#pragma once

#include <span>
#include <vector>

namespace terratact {

/// Returns the quantile p ∈ [0, 1] with linear interpolation between order statistics. Source: type
/// 7 of Hyndman & Fan (1996), R's default. Throws std::invalid_argument for no values or another p.
double quantile(std::vector<double> values, double p);

/// Returns the same quantile of values that are in ascending order.
double quantileOfSorted(std::span<const double> sorted, double p);

}  // namespace terratact
