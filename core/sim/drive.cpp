#include "core/sim/drive.h"

#include "core/sim/rest_pose.h"

namespace terratact {

namespace {

constexpr double kBehind = 0.65;  // [m] the robot reaches this far behind its base
constexpr double kAhead = 0.80;   // [m] the last bin ends this far ahead at most
constexpr double kSpeed = 0.3;    // [m/s]

OptionalHeights known(const Heights& heights)
{
    OptionalHeights result;
    for (std::size_t i = 0; i < heights.size(); ++i) result[i] = heights[i];
    return result;
}

}  // namespace

DriveStyle randomDriveStyle(std::mt19937_64& rng)
{
    const double rear = std::uniform_real_distribution<double>(-0.26, 0.70)(rng);
    const double torque = std::uniform_real_distribution<double>(12.0, 24.0)(rng);
    return {rear, torque};
}

std::vector<double> stopsOver(const TerrainProfile& terrain, double spacing)
{
    const double first = terrain.begin() + kBehind;
    const double last = terrain.end() - kAhead;
    if (last < first) return {terrain.begin() - binCentre(0)};
    std::vector<double> stops;
    for (int k = 0; first + spacing * k <= last; ++k) stops.push_back(first + spacing * k);
    return stops;
}

std::vector<Scene> driveOver(const RobotModel& robot, const TerrainProfile& terrain,
                             const std::vector<double>& stops, const std::string& run,
                             const DriveStyle& style, const SensorNoise& noise,
                             std::mt19937_64& rng, int& skipped)
{
    std::vector<Scene> scenes;
    double pitch = 0.0;
    for (const double x : stops) {
        const auto rest = restPose(robot, terrain, x, PressTorque{style.pressTorque},
                                   HoldAngle{style.rearAngle}, pitch);
        if (!rest) {
            ++skipped;
            continue;
        }
        pitch = rest->pose.pitch;
        const Heights truth = binHeights(terrain, imuPosition(robot, rest->pose));
        const Proprioception readings =
            noisy(exactReadings(robot, *rest), noise, robot.forceSaturation, rng);
        scenes.push_back({.run = run,
                          .time = (x - stops.front()) / kSpeed,
                          .s = readings,
                          .truth = known(noisy(truth, noise, rng))});
    }
    return scenes;
}

}  // namespace terratact
