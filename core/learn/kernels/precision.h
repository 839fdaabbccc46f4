#pragma once

#include <cstdint>

namespace terratact {

/// Precision of the products in a variance. Covariances and means are always double and through all
/// rows.
enum class Precision : std::uint8_t {
    /// float, and only the rows that matter; docs/speed.md gives the gain, GaussianProcess::usable
    /// the error
    Single,
    Double
};

}  // namespace terratact
