#include "app/modelling/simulation/simulated_scenes.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <numeric>
#include <random>
#include <type_traits>
#include <utility>

#include "core/learn/data/ground_file.h"
#include "core/learn/data/profile_file.h"
#include "core/sim/drive.h"
#include "core/sim/ground/hazard_terrain.h"
#include "core/sim/ground/random_draw.h"
#include "core/sim/ground/random_ground.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/two_track_drive.h"

namespace terratact {
namespace {

constexpr double kStopSpacing = 0.1;  // [m] between the stops of a drive over a file
constexpr double kSecondsPerScene =
    10.0;                     // duration of a scene for sensor drift: drive, press, stand
constexpr int kBoxRuns = 28;  // drives of the paper's training set
constexpr int kVariedScenesPerRun = 8, kHazardScenesPerRun = 16;
constexpr int kPresetScenes = 1400;

/// Returns the function that applies a sensor fault to the scenes of one drive.
std::function<Proprioception(const Proprioception&)>
faultyReading(const SensorFault& fault, const RobotModel& robot, std::uint64_t seed)
{
    struct State {
        FaultyScenes scenes;
        double time;
    };
    const auto state = std::make_shared<State>(State{FaultyScenes(fault, robot, seed), 0.0});
    return [state](const Proprioception& s) {
        const Proprioception read = state->scenes.apply(s, state->time);
        state->time += kSecondsPerScene;
        return read;
    };
}

/// Returns the conditions of the next drive; uses random numbers only if some drives are on soft ground.
template <class Ground>
DriveConditions nextConditions(const SimulatedScenes& options, const RobotModel& robot,
                               std::mt19937_64& rng)
{
    SensorNoise noise;
    if (options.exactTruth) noise.height = 0.0;
    DriveConditions conditions{.noise = noise};
    if constexpr (std::is_same_v<Ground, TerrainProfile>)
        conditions = disturbedDrive(noise, robot.forceSaturation, options.disturbance);
    if (options.softDrives > 0.0
        && std::uniform_real_distribution<double>(0.0, 1.0)(rng) < options.softDrives)
        conditions.ground = randomSoftGround(rng);
    if (options.sensorFault)
        conditions.reading = faultyReading(*options.sensorFault, robot, options.seed);
    return conditions;
}

/// Drives over the stops, and adds the scenes and the drive's part of the map.
template <class AnyScene, class Ground>
void addDrive(DrivenScenes<AnyScene>& recording, const RobotModel& robot, const Ground& terrain,
              const std::vector<double>& stops, const std::string& run, const DriveStyle& style,
              DriveConditions conditions, std::mt19937_64& rng)
{
    std::vector<TwoTrackPose> poses;
    if constexpr (std::is_same_v<Ground, GroundLines>)
        conditions.stood = [&](const TwoTrackPose& pose) { poses.push_back(pose); };
    else
        conditions.rested = [&](const RestPose& rest) {
            const Pose& p = rest.pose;
            poses.push_back(
                {.base = p.base, .pitch = p.pitch, .flippers = {p.front, p.front, p.rear, p.rear}});
        };
    auto scenes = driveOver(robot, terrain, stops, run, style, conditions, rng, recording.skipped);
    if (recording.map.isWanted()) {
        if constexpr (std::is_same_v<AnyScene, TwoTrackScene>)
            recording.map.add(run, terrain, std::move(poses), scenes);
        else
            recording.map.add(run, GroundLines(terrain), std::move(poses), onBothSides(scenes));
    }
    std::move(scenes.begin(), scenes.end(), std::back_inserter(recording.scenes));
}

/// Kind of a drive's scenes: of one plane over profiles, of two tracks over ground lines.
template <class Ground>
using SceneOver = std::conditional_t<std::is_same_v<Ground, GroundLines>, TwoTrackScene, Scene>;

/// Makes `runs` drives over random ground; stops are spread evenly so that `count` scenes result.
template <class Ground>
DrivenScenes<SceneOver<Ground>>
drivePreset(const RobotModel& robot, const SimulatedScenes& options, int runs, int count,
            const std::function<Ground(std::mt19937_64&)>& ground,
            const std::function<DriveStyle(std::mt19937_64&)>& style)
{
    std::mt19937_64 rng(options.seed);
    DrivenScenes<SceneOver<Ground>> recording{.scenes = {}, .map = SimulatedMap(options.map)};
    for (int run = 0; run < runs; ++run) {
        const Ground terrain = ground(rng);
        const int stops = (count * (run + 1)) / runs - (count * run) / runs;
        const std::vector<double> all = stopsOver(terrain, 0.01);
        std::vector<double> chosen;
        chosen.reserve(static_cast<std::size_t>(stops));
        const double offset = std::uniform_real_distribution<double>(0.0, 1.0)(rng);
        for (int k = 0; k < stops; ++k)
            chosen.push_back(all[static_cast<std::size_t>((k + offset) / stops
                                                          * static_cast<double>(all.size()))]);
        if (chosen.empty()) continue;
        const DriveConditions conditions = nextConditions<Ground>(options, robot, rng);
        addDrive(recording, robot, terrain, chosen, std::to_string(run + 1), style(rng), conditions,
                 rng);
    }
    return recording;
}

/// Makes every stop over every profile, or `count` of them at random.
template <class Ground>
DrivenScenes<SceneOver<Ground>> driveProfiles(const RobotModel& robot,
                                              const SimulatedScenes& options,
                                              const std::vector<Ground>& profiles)
{
    std::vector<std::vector<double>> stops;
    std::vector<std::size_t> owner;
    for (std::size_t p = 0; p < profiles.size(); ++p) {
        stops.push_back(stopsOver(profiles[p], kStopSpacing));
        owner.insert(owner.end(), stops.back().size(), p);
    }
    std::mt19937_64 rng(options.seed);
    std::vector<std::size_t> order(owner.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (options.count > 0 && static_cast<std::size_t>(options.count) < order.size()) {
        std::shuffle(order.begin(), order.end(), rng);
        order.resize(static_cast<std::size_t>(options.count));
        std::sort(order.begin(), order.end());
    }
    DrivenScenes<SceneOver<Ground>> recording{.scenes = {}, .map = SimulatedMap(options.map)};
    std::size_t firstOfProfile = 0;
    auto next = order.begin();
    for (std::size_t p = 0; p < profiles.size(); ++p) {
        std::vector<double> chosen;
        for (; next != order.end() && owner[*next] == p; ++next)
            chosen.push_back(stops[p][*next - firstOfProfile]);
        firstOfProfile += stops[p].size();
        if (chosen.empty()) continue;
        const DriveConditions conditions = nextConditions<Ground>(options, robot, rng);
        addDrive(recording, robot, profiles[p], chosen, std::to_string(p + 1),
                 randomDriveStyle(rng), conditions, rng);
    }
    return recording;
}

Hazard anyHazard(std::mt19937_64& rng)
{
    std::uniform_int_distribution<std::size_t> kind(0, kHazards.size() - 1);
    return kHazards.at(kind(rng));
}

/// Returns 0 for level ground, or the roughness of an ISO 8608 class A to D.
double anyRoughness(std::mt19937_64& rng)
{
    const double roughnessClass = std::uniform_real_distribution<double>(-1.0, 3.0)(rng);
    return roughnessClass < 0.0 ? 0.0 : classRoughness(roughnessClass);
}

DriveStyle boxStyle(std::mt19937_64& rng)
{
    return {std::uniform_real_distribution<double>(0.05, 0.45)(rng), DriveStyle{}.pressTorque};
}

/// Returns how many stops of a preset are wanted.
int presetStops(const SimulatedScenes& options)
{
    return options.count > 0 ? options.count : kPresetScenes;
}

}  // namespace

Result<DrivenScenes<Scene>> simulateScenes(const RobotModel& robot, const SimulatedScenes& options)
{
    const RobotModel driven = disturbed(robot, options.disturbance);
    using Ground = std::function<TerrainProfile(std::mt19937_64&)>;
    const int count = presetStops(options);
    if (options.terrain == "boxes")
        return drivePreset(driven, options, kBoxRuns, count, Ground(randomBoxTerrain), boxStyle);
    if (options.terrain == "varied")
        return drivePreset(driven, options, std::max(1, count / kVariedScenesPerRun), count,
                           Ground(randomVariedTerrain), randomDriveStyle);
    if (options.terrain == "hazards") {
        const Ground ground = [](std::mt19937_64& rng) {
            const Hazard hazard = anyHazard(rng);
            return randomHazardTerrain(hazard, anyRoughness(rng), rng);
        };
        return drivePreset(driven, options, std::max(1, count / kHazardScenesPerRun), count, ground,
                           randomDriveStyle);
    }
    const auto file = readProfiles(options.terrain, options.step, options.blocks);
    if (!file) return file.error();
    return driveProfiles(driven, options, file->profiles);
}

Result<DrivenScenes<TwoTrackScene>> simulateTrackScenes(const RobotModel& robot,
                                                        const SimulatedScenes& options)
{
    using Ground = std::function<GroundLines(std::mt19937_64&)>;
    const int count = presetStops(options);
    const std::vector<double> ys = groundYs(robot);
    if (options.terrain == "boxes") {
        const Ground ground = [](std::mt19937_64& rng) {
            return GroundLines(randomBoxTerrain(rng));
        };
        return drivePreset(robot, options, kBoxRuns, count, ground, boxStyle);
    }
    if (options.terrain == "varied") {
        const Ground ground = [&](std::mt19937_64& rng) {
            const GroundKind kind = randomGroundKind(rng);
            return randomGround(kind, ys, rng);
        };
        return drivePreset(robot, options, std::max(1, count / kVariedScenesPerRun), count, ground,
                           randomDriveStyle);
    }
    if (options.terrain == "hazards") {
        const Ground ground = [&](std::mt19937_64& rng) {
            const Hazard hazard = anyHazard(rng);
            const auto side = static_cast<HazardSide>(whole(rng, 0, 2));
            return randomHazardGround(hazard, side, anyRoughness(rng), ys, rng);
        };
        return drivePreset(robot, options, std::max(1, count / kHazardScenesPerRun), count, ground,
                           randomDriveStyle);
    }
    const auto file = readGrounds(options.terrain, options.step, options.blocks);
    if (!file) return file.error();
    return driveProfiles(robot, options, file->grounds);
}

}  // namespace terratact
