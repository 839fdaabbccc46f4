#pragma once

namespace terratact {

/// Returns Φ(z), the share of N(0, 1) below z.
double normalCdf(double z);

/// Returns Φ⁻¹(p), the quantile of N(0, 1). p: between 0 and 1, without the ends. Throws
/// std::domain_error for p outside 0 … 1 and std::overflow_error for an end.
double normalQuantile(double p);

}  // namespace terratact
