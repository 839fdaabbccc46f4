#pragma once

#include <random>

namespace terratact {

/// Returns a number in [0, 1) that is the same with every standard library.
inline double randomUnit(std::mt19937_64& rng)
{
    return static_cast<double>(rng() >> 11U) * 0x1.0p-53;
}

}  // namespace terratact
