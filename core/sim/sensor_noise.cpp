#include "core/sim/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/learn/data/columns.h"

namespace terratact {
namespace {

void check(const SensorNoise& noise)
{
    for (const double sd : {noise.pitch, noise.flipperAngle, noise.current, noise.forceShare,
                            noise.forceFloor, noise.height})
        if (!(sd >= 0.0) || !std::isfinite(sd))
            throw std::invalid_argument("noisy: a standard deviation is negative or not finite");
}

void check(const SensorNoise& noise, double saturation)
{
    check(noise);
    if (!(saturation > 0.0)) throw std::invalid_argument("noisy: saturation is not above 0");
}

/// Returns x plus Gaussian noise of that sd; x itself if sd is 0.
double withNoise(double x, double sd, std::mt19937_64& rng)
{
    std::normal_distribution<double> standard;
    return x + sd * standard(rng);
}

void addCurrentNoise(std::optional<double>& current, const SensorNoise& noise, std::mt19937_64& rng)
{
    if (current)
        current = std::clamp(withNoise(*current, noise.current, rng), -kMaxSceneCurrent,
                             kMaxSceneCurrent);
}

void addForceNoise(std::array<std::optional<double>, kForceElements>& forces,
                   const SensorNoise& noise, double saturation, std::mt19937_64& rng)
{
    for (std::optional<double>& force : forces) {
        if (!force) continue;
        const double sd = std::hypot(noise.forceShare * *force, noise.forceFloor);
        force = std::clamp(withNoise(*force, sd, rng), 0.0, saturation);
    }
}

}  // namespace

Proprioception noisy(const Proprioception& exact, const SensorNoise& noise, double saturation,
                     std::mt19937_64& rng)
{
    check(noise, saturation);
    Proprioception s = exact;
    s.pitch = withNoise(s.pitch, noise.pitch, rng);
    s.front = withNoise(s.front, noise.flipperAngle, rng);
    s.rear = withNoise(s.rear, noise.flipperAngle, rng);
    addCurrentNoise(s.frontCurrent, noise, rng);
    addCurrentNoise(s.rearCurrent, noise, rng);
    addForceNoise(s.force, noise, saturation, rng);
    return s;
}

TwoTrackReadings noisy(const TwoTrackReadings& exact, const SensorNoise& noise, double saturation,
                       std::mt19937_64& rng)
{
    check(noise, saturation);
    TwoTrackReadings s = exact;
    s.pitch = withNoise(s.pitch, noise.pitch, rng);
    s.roll = withNoise(s.roll, noise.pitch, rng);
    for (double& angle : s.flippers) angle = withNoise(angle, noise.flipperAngle, rng);
    if (s.differential) s.differential = withNoise(*s.differential, noise.flipperAngle, rng);
    for (std::optional<double>& current : s.currents) addCurrentNoise(current, noise, rng);
    for (auto& forces : s.forces) addForceNoise(forces, noise, saturation, rng);
    return s;
}

SideForces sidesOf(const Measurement& measurement, const SensorNoise& noise,
                   const RobotModel& robot, std::mt19937_64& rng)
{
    SideForces sides;
    for (std::size_t e = 0; e < kForceElements; ++e) {
        if (measurement.missing[kFirstForceFeature + e]) continue;
        const auto has = [&](Side side) {
            return haveElement(robot.forceArrays, side, static_cast<int>(e));
        };
        const double mean = measurement.force[e];
        const double sd = std::hypot(noise.forceShare * mean, noise.forceFloor);
        const double most = std::max(0.0, std::min(mean, robot.forceSaturation - mean));
        const double drawn = std::clamp(withNoise(0.0, sd, rng), -most, most);
        const double half = has(Side::Left) && has(Side::Right) ? drawn : 0.0;
        if (has(Side::Left)) sides.left[e] = mean + half;
        if (has(Side::Right)) sides.right[e] = mean - half;
    }
    return sides;
}

Heights noisy(const Heights& exact, const SensorNoise& noise, std::mt19937_64& rng)
{
    check(noise);
    Heights h = exact;
    for (double& height : h) height = withNoise(height, noise.height, rng);
    return h;
}

}  // namespace terratact
