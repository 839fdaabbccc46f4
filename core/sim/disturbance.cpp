#include "core/sim/disturbance.h"

#include <algorithm>

#include "core/base/named.h"

namespace terratact {
namespace {

constexpr auto kDisturbanceNames =
    namesOf<Disturbance>("none", "imu-noise", "forces-high", "forces-low", "dead-element",
                         "soft-ground", "light-robot", "heavy-robot", "friction-free");

constexpr double kNoisyPitch = 0.0175;    // [rad] 1°
constexpr double kForceError = 0.25;      // share
constexpr std::size_t kDeadElement = 3;   // element 4
constexpr double kSoftLayer = 0.025;      // [m], less than the radius of a flipper's tip
constexpr double kSoftStiffness = 120.0;  // [N/m] per 5 mm of ground, under both tracks
constexpr double kMassError = 0.20;       // share
constexpr double kSlide = 0.05;           // [m]

void scaleForces(Proprioception& s, double factor, double saturation)
{
    for (std::optional<double>& force : s.force)
        if (force) force = std::clamp(factor * *force, 0.0, saturation);
}

void scaleMasses(RobotModel& robot, double factor)
{
    for (double* const mass : {&robot.bodyMass, &robot.front.mass, &robot.rear.mass})
        *mass *= factor;
}

}  // namespace

std::string_view name(Disturbance disturbance)
{
    return nameIn(kDisturbanceNames, disturbance);
}

std::optional<Disturbance> disturbanceFromName(std::string_view text)
{
    return valueIn<Disturbance>(kDisturbanceNames, text);
}

SensorNoise disturbed(SensorNoise noise, Disturbance disturbance)
{
    if (disturbance == Disturbance::ImuNoise) noise.pitch = kNoisyPitch;
    return noise;
}

GroundOptions disturbed(GroundOptions ground, Disturbance disturbance)
{
    if (disturbance != Disturbance::SoftGround) return ground;
    ground.softLayer = kSoftLayer;
    ground.softStiffness = kSoftStiffness;
    return ground;
}

RobotModel disturbed(RobotModel robot, Disturbance disturbance)
{
    if (disturbance == Disturbance::LightRobot) scaleMasses(robot, 1.0 - kMassError);
    if (disturbance == Disturbance::HeavyRobot) scaleMasses(robot, 1.0 + kMassError);
    return robot;
}

Proprioception disturbed(Proprioception s, double saturation, Disturbance disturbance)
{
    if (disturbance == Disturbance::ForcesHigh) scaleForces(s, 1.0 + kForceError, saturation);
    if (disturbance == Disturbance::ForcesLow) scaleForces(s, 1.0 - kForceError, saturation);
    if (disturbance == Disturbance::DeadElement) s.force[kDeadElement] = 0.0;
    return s;
}

DriveConditions disturbedDrive(const SensorNoise& noise, double saturation, Disturbance disturbance)
{
    DriveConditions conditions;
    conditions.noise = disturbed(noise, disturbance);
    conditions.ground = disturbed(GroundOptions{}, disturbance);
    conditions.reading = [saturation, disturbance](const Proprioception& s) {
        return disturbed(s, saturation, disturbance);
    };
    if (disturbance == Disturbance::FrictionFree) conditions.slide = kSlide;
    return conditions;
}

}  // namespace terratact
