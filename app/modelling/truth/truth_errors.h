#pragma once

#include <cstddef>

namespace terratact {

/// Errors of heights against those that the scenes file held before.
struct TruthErrors {
    std::size_t bins = 0;
    double bias = 0.0, meanError = 0.0, rms = 0.0;  ///< [m]
    double worst = 0.0;                             ///< [m] largest |error|
    double within = 0.0;  ///< share with |error| ≤ 1.28 sd: 0.8 is right

    /// Adds the error of a height with its sd [m]. Numbers but bins and worst are sums until finish().
    void add(double error, double sd);
    void finish();
};

}  // namespace terratact
