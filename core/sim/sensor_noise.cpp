#include "core/sim/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

void check(const SensorNoise& noise)
{
    for (const double sd : {noise.pitch, noise.flipperAngle, noise.current, noise.forceShare,
                            noise.forceFloor, noise.height})
        if (!(sd >= 0.0) || !std::isfinite(sd))
            throw std::invalid_argument("noisy: a standard deviation is negative or not finite");
}

/// Returns x plus Gaussian noise of that sd; x itself if sd is 0.
double withNoise(double x, double sd, std::mt19937_64& rng)
{
    std::normal_distribution<double> standard;
    return x + sd * standard(rng);
}

}  // namespace

Proprioception noisy(const Proprioception& exact, const SensorNoise& noise, double saturation,
                     std::mt19937_64& rng)
{
    check(noise);
    if (!(saturation > 0.0)) throw std::invalid_argument("noisy: saturation is not above 0");
    Proprioception s = exact;
    s.pitch = withNoise(s.pitch, noise.pitch, rng);
    s.front = withNoise(s.front, noise.flipperAngle, rng);
    s.rear = withNoise(s.rear, noise.flipperAngle, rng);
    if (s.frontCurrent) s.frontCurrent = withNoise(*s.frontCurrent, noise.current, rng);
    if (s.rearCurrent) s.rearCurrent = withNoise(*s.rearCurrent, noise.current, rng);
    for (std::optional<double>& force : s.force) {
        if (!force) continue;
        const double sd = std::hypot(noise.forceShare * *force, noise.forceFloor);
        force = std::clamp(withNoise(*force, sd, rng), 0.0, saturation);
    }
    return s;
}

Heights noisy(const Heights& exact, const SensorNoise& noise, std::mt19937_64& rng)
{
    check(noise);
    Heights h = exact;
    for (double& height : h) height = withNoise(height, noise.height, rng);
    return h;
}

}  // namespace terratact
