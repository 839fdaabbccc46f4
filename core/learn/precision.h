#pragma once

#include <cstdint>

namespace terratact {

/// Of the products with L⁻¹ in a variance.  Covariances and means are always double.
enum class Precision : std::uint8_t {
    Single,  ///< half the memory and twice the speed; error bound: core/learn/inverse_factor.h
    Double
};

}  // namespace terratact
