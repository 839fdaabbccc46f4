#pragma once

#include <random>

#include "core/robot/measurement.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Standard deviations of the simulated sensors.
struct SensorNoise {
    double pitch = 0.0087;         ///< [rad] 0.5°, an MTi's static accuracy
    double flipperAngle = 0.0017;  ///< [rad] 0.1°
    double current = 0.05;         ///< [A] assumed
    double forceShare = 0.10;      ///< share of the force
    double forceFloor = 0.3;       ///< [N]
    double height = 0.012;         ///< [m] of the scanner that gives the training truth

    static SensorNoise none() { return {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}; }
};

/// What the sensors report: Gaussian noise added, of a force with variance
///   (forceShare · force)² + forceFloor²,
/// and the force kept within 0 and `saturation` [N].  What is not measured stays so.
/// Throws std::invalid_argument for a negative standard deviation or saturation ≤ 0.
Proprioception noisy(const Proprioception& exact, const SensorNoise& noise, double saturation,
                     std::mt19937_64& rng);

/// What the scanner reports of the terrain.
Heights noisy(const Heights& exact, const SensorNoise& noise, std::mt19937_64& rng);

}  // namespace terratact
