#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <random>

#include "app/cli/commands.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/learn/data/profile_file.h"
#include "core/learn/data/scene_file.h"
#include "core/sim/drive.h"
#include "core/sim/hazard_terrain.h"
#include "core/sim/random_terrain.h"
#include "core/sim/terrain_shapes.h"

namespace terratact {

namespace {

constexpr double kSpacing = 0.1;  // [m] distance between the stops of a drive
constexpr double kSecondsPerScene =
    10.0;                     // duration of a scene for sensor drift: drive, press, stand
constexpr int kBoxRuns = 28;  // drives of the paper's training set
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
DriveConditions nextConditions(const SimulateOptions& options, const RobotModel& robot,
                               std::mt19937_64& rng)
{
    SensorNoise noise;
    if (options.exactTruth) noise.height = 0.0;
    DriveConditions conditions = disturbedDrive(noise, robot.forceSaturation, options.disturbance);
    if (options.softDrives > 0.0
        && std::uniform_real_distribution<double>(0.0, 1.0)(rng) < options.softDrives)
        conditions.ground = randomSoftGround(rng);
    if (options.sensorFault)
        conditions.reading = faultyReading(*options.sensorFault, robot, options.seed);
    return conditions;
}

struct Recording {
    std::vector<Scene> scenes;
    int skipped = 0;
};

/// Makes `runs` drives over random ground; stops are spread evenly so that `count` scenes result.
Recording drivePreset(const RobotModel& robot, const SimulateOptions& options, int runs, int count,
                      const std::function<TerrainProfile(std::mt19937_64&)>& ground,
                      const std::function<DriveStyle(std::mt19937_64&)>& style)
{
    std::mt19937_64 rng(options.seed);
    Recording recording;
    for (int run = 0; run < runs; ++run) {
        const TerrainProfile terrain = ground(rng);
        const int stops = (count * (run + 1)) / runs - (count * run) / runs;
        const std::vector<double> all = stopsOver(terrain, 0.01);
        std::vector<double> chosen;
        chosen.reserve(static_cast<std::size_t>(stops));
        const double offset = std::uniform_real_distribution<double>(0.0, 1.0)(rng);
        for (int k = 0; k < stops; ++k)
            chosen.push_back(all[static_cast<std::size_t>((k + offset) / stops
                                                          * static_cast<double>(all.size()))]);
        if (chosen.empty()) continue;
        const DriveConditions conditions = nextConditions(options, robot, rng);
        auto scenes = driveOver(robot, terrain, chosen, std::to_string(run + 1), style(rng),
                                conditions, rng, recording.skipped);
        std::move(scenes.begin(), scenes.end(), std::back_inserter(recording.scenes));
    }
    return recording;
}

/// Makes every stop over every profile, or `count` of them at random.
Recording driveProfiles(const RobotModel& robot, const SimulateOptions& options,
                        const std::vector<TerrainProfile>& profiles)
{
    std::vector<std::vector<double>> stops;
    std::vector<std::size_t> owner;
    for (std::size_t p = 0; p < profiles.size(); ++p) {
        stops.push_back(stopsOver(profiles[p], kSpacing));
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
    Recording recording;
    std::size_t firstOfProfile = 0;
    auto next = order.begin();
    for (std::size_t p = 0; p < profiles.size(); ++p) {
        std::vector<double> chosen;
        for (; next != order.end() && owner[*next] == p; ++next)
            chosen.push_back(stops[p][*next - firstOfProfile]);
        firstOfProfile += stops[p].size();
        if (chosen.empty()) continue;
        const DriveConditions conditions = nextConditions(options, robot, rng);
        auto scenes = driveOver(robot, profiles[p], chosen, std::to_string(p + 1),
                                randomDriveStyle(rng), conditions, rng, recording.skipped);
        std::move(scenes.begin(), scenes.end(), std::back_inserter(recording.scenes));
    }
    return recording;
}

/// Returns a random hazard on level ground, or on roughness of ISO 8608 classes A to D.
TerrainProfile anyHazard(std::mt19937_64& rng)
{
    std::uniform_int_distribution<std::size_t> kind(0, kHazards.size() - 1);
    const Hazard hazard = kHazards.at(kind(rng));
    const double roughnessClass = std::uniform_real_distribution<double>(-1.0, 3.0)(rng);
    const double roughness = roughnessClass < 0.0 ? 0.0 : 16e-6 * std::pow(4.0, roughnessClass);
    return randomHazardTerrain(hazard, roughness, rng);
}

Result<Recording> drive(const RobotModel& robot, const SimulateOptions& options)
{
    const int count = options.count > 0 ? options.count : kPresetScenes;
    if (options.terrain == "boxes") {
        const auto style = [](std::mt19937_64& rng) {
            return DriveStyle{std::uniform_real_distribution<double>(0.05, 0.45)(rng),
                              DriveStyle{}.pressTorque};
        };
        return drivePreset(robot, options, kBoxRuns, count, randomBoxTerrain, style);
    }
    if (options.terrain == "varied") {
        constexpr int kScenesPerRun = 8;
        const int runs = std::max(1, count / kScenesPerRun);
        return drivePreset(robot, options, runs, count, randomVariedTerrain, randomDriveStyle);
    }
    if (options.terrain == "hazards") {
        constexpr int kScenesPerRun = 16;
        const int runs = std::max(1, count / kScenesPerRun);
        return drivePreset(robot, options, runs, count, anyHazard, randomDriveStyle);
    }
    const auto file = readProfiles(options.terrain, options.step, options.blocks);
    if (!file) return file.error();
    return driveProfiles(robot, options, file->profiles);
}

}  // namespace

Status simulate(const SimulateOptions& options)
{
    const auto robot = readRobotModel(options.robot);
    if (!robot) return robot.error();
    const auto recording = drive(disturbed(*robot, options.disturbance), options);
    if (!recording) return recording.error();
    if (recording->scenes.empty())
        return Error{
            fmt::format("{}: the robot finds no rest pose anywhere on it", options.terrain), 0};
    if (Status written = writeText(options.out, scenesText(recording->scenes)); !written)
        return written;
    std::FILE* const messages = messagesBeside(options.out);
    printText(messages, "{} scenes over {} written to {}", recording->scenes.size(),
              options.terrain, options.out);
    if (recording->skipped > 0)
        printText(messages, " ({} stops left out: no rest pose)", recording->skipped);
    printText(messages, "\n");
    return Done{};
}

}  // namespace terratact
