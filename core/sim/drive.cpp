#include "core/sim/drive.h"

#include <cmath>
#include <optional>
#include <utility>

namespace terratact {

namespace {

constexpr double kBehind =
    0.65;  // [m] of terrain behind the first base; it is level before its begin
constexpr double kAhead = 0.80;      // [m] largest distance of the last bin's end ahead
constexpr double kSlideStep = 0.01;  // [m]

/// One stop of a drive: the robot's rest pose on the terrain.
class Stop {
public:
    Stop(const RobotModel& robot, const TerrainProfile& terrain, const DriveStyle& style,
         const DriveConditions& conditions, double startPitch)
        : robot_(robot), terrain_(terrain), style_(style), conditions_(conditions),
          startPitch_(startPitch)
    {
    }

    /// Returns the scene at x, without its run and time. pitch: becomes that of the rest pose.
    std::optional<Scene> measured(double x, double& pitch, std::mt19937_64& rng) const
    {
        const auto rest = restNear(x);
        if (!rest) return std::nullopt;
        pitch = rest->pose.pitch;
        if (conditions_.rested) conditions_.rested(*rest);
        const Heights truth = binHeights(terrain_, imuPosition(robot_, rest->pose));
        const Proprioception readings =
            noisy(exactReadings(robot_, *rest), conditions_.noise, robot_.forceSaturation, rng);
        return Scene{.run = {},
                     .time = 0.0,
                     .s = conditions_.reading ? conditions_.reading(readings) : readings,
                     .truth = known(noisy(truth, conditions_.noise, rng))};
    }

private:
    /// Returns the rest pose at x, or where the robot stops when it slides from there.
    Result<RestPose> restNear(double x) const
    {
        Result<RestPose> rest = restAt(x);
        if (!rest || !(conditions_.slide > 0.0)) return rest;
        const RestPose back = slid(*rest, -kSlideStep);
        const RestPose ahead = slid(*rest, kSlideStep);
        return back.energy < ahead.energy ? back : ahead;
    }

    Result<RestPose> restAt(double x) const
    {
        return restPose(robot_, terrain_, x, PressTorque{style_.pressTorque},
                        HoldAngle{style_.rearAngle}, startPitch_, conditions_.ground);
    }

    /// Slides from `rest` in steps of `step` while the energy falls.
    RestPose slid(RestPose rest, double step) const
    {
        const double start = rest.pose.base.x;
        const auto steps = std::lround(conditions_.slide / kSlideStep);
        for (long k = 1; k <= steps; ++k) {
            const auto next = restAt(start + static_cast<double>(k) * step);
            if (!next || !(next->energy < rest.energy)) break;
            rest = *next;
        }
        return rest;
    }

    const RobotModel& robot_;
    const TerrainProfile& terrain_;
    const DriveStyle& style_;
    const DriveConditions& conditions_;
    double startPitch_;
};

std::vector<double> stopsBetween(double begin, double end, double spacing)
{
    const double first = begin + kBehind;
    const double last = end - kAhead;
    if (last < first) return {begin - binCentre(0)};
    std::vector<double> stops;
    for (int k = 0; first + spacing * k <= last; ++k) stops.push_back(first + spacing * k);
    return stops;
}

}  // namespace

OptionalHeights known(const Heights& heights)
{
    OptionalHeights result;
    for (std::size_t i = 0; i < heights.size(); ++i) result[i] = heights[i];
    return result;
}

DriveStyle randomDriveStyle(std::mt19937_64& rng)
{
    const double rear = std::uniform_real_distribution<double>(-0.26, 0.70)(rng);
    const double torque = std::uniform_real_distribution<double>(12.0, 24.0)(rng);
    return {.rearAngle = rear, .pressTorque = torque};
}

GroundOptions randomSoftGround(std::mt19937_64& rng)
{
    std::uniform_real_distribution<double> share(0.0, 1.0);
    GroundOptions ground;
    ground.softLayer = 0.012 + 0.016 * share(rng);
    ground.softStiffness = 60.0 * std::pow(4.0, share(rng));
    return ground;
}

std::vector<double> stopsOver(const TerrainProfile& terrain, double spacing)
{
    return stopsBetween(terrain.begin(), terrain.end(), spacing);
}

std::vector<double> stopsOver(const GroundLines& terrain, double spacing)
{
    return stopsBetween(terrain.begin(), terrain.end(), spacing);
}

std::vector<Scene> driveOver(const RobotModel& robot, const TerrainProfile& terrain,
                             const std::vector<double>& stops, const std::string& run,
                             const DriveStyle& style, const DriveConditions& conditions,
                             std::mt19937_64& rng, int& skipped)
{
    std::vector<Scene> scenes;
    double pitch = 0.0;
    for (const double x : stops) {
        std::optional<Scene> scene =
            Stop(robot, terrain, style, conditions, pitch).measured(x, pitch, rng);
        if (!scene) {
            ++skipped;
            continue;
        }
        scene->run = run;
        scene->time = (x - stops.front()) / kDriveSpeed;
        scenes.push_back(*std::move(scene));
    }
    return scenes;
}

}  // namespace terratact
