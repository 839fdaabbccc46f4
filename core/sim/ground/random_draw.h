#pragma once

#include <cmath>
#include <random>

namespace terratact {

// Draws for random terrain. Each draw is a statement of its own where it is used. The evaluation
// order of operands is the compiler's choice, but the same seed must give the same ground.

inline double uniform(std::mt19937_64& rng, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(rng);
}

inline double logUniform(std::mt19937_64& rng, double low, double high)
{
    return low * std::exp(uniform(rng, 0.0, std::log(high / low)));
}

inline int whole(std::mt19937_64& rng, int low, int high)
{
    return std::uniform_int_distribution<int>(low, high)(rng);
}

inline bool chance(std::mt19937_64& rng, double probability)
{
    return uniform(rng, 0.0, 1.0) < probability;
}

/// Returns a value of that size, up or down.
inline double eitherWay(std::mt19937_64& rng, double low, double high)
{
    const double size = uniform(rng, low, high);
    return chance(rng, 0.5) ? size : -size;
}

}  // namespace terratact
