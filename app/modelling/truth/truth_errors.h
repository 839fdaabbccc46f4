#pragma once

#include <cstddef>

namespace terratact {

/// Errors of heights relative to the earlier heights of the scenes file.
struct TruthErrors {
    std::size_t bins = 0;
    double bias = 0.0, meanError = 0.0, rms = 0.0;  ///< [m]
    double worst = 0.0;                             ///< [m] largest |error|
    double within = 0.0;  ///< share with |error| ≤ 1.28 sd; 0.8 if the sd is right

    /// Adds the error of a height with its sd [m]. Until finish(), all numbers except bins and worst are sums.
    void add(double error, double sd);
    void finish();
};

}  // namespace terratact
