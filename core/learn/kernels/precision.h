#pragma once

#include <cstdint>

namespace terratact {

/// Of the products in a variance.  Covariances and means are always double, and through all rows of a process.
enum class Precision : std::uint8_t {
    Single,  ///< in float, and through no more rows than matter: docs/speed.md says what that saves, and
             ///< GaussianProcess::usable how far off it is
    Double
};

}  // namespace terratact
