// Measures the posterior check of both sides on simulated scenes. Prints its cost and the share of refused scenes,
// without a fault and with one of each kind of sensor. Arguments: seed, drives, and a file of ground lines
// (docs/files.md) to drive over instead of generated ground.
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/atem/probe/arm_choice.h"
#include "core/infer/two_track_estimator.h"
#include "core/learn/data/ground_file.h"
#include "core/robot/side_plane.h"
#include "core/sim/ground/random_ground.h"
#include "core/sim/two_track_check.h"
#include "core/sim/two_track_drive.h"
#include "tests/bench/shipped_model.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

std::vector<GroundLines> generatedGround(const RobotModel& robot, int drives, std::mt19937_64& rng)
{
    std::vector<GroundLines> grounds;
    grounds.reserve(static_cast<std::size_t>(drives));
    for (int drive = 0; drive < drives; ++drive)
        grounds.push_back(randomGround(randomGroundKind(rng), groundYs(robot), rng));
    return grounds;
}

std::vector<GroundLines> groundOf(const std::string& path, int drives)
{
    auto file = readGrounds(path, 0.1, false);
    if (!file) throw std::runtime_error(file.error().text);
    if (file->grounds.size() > static_cast<std::size_t>(drives))
        file->grounds.erase(file->grounds.begin() + drives, file->grounds.end());
    return std::move(file->grounds);
}

/// softShare: share of the drives over soft ground.
std::vector<TwoTrackScene> scenesOver(const std::vector<GroundLines>& grounds,
                                      const RobotModel& robot, double softShare,
                                      std::mt19937_64& rng)
{
    std::vector<TwoTrackScene> scenes;
    int skipped = 0;
    for (const GroundLines& ground : grounds) {
        DriveConditions conditions;
        if (std::uniform_real_distribution<double>(0.0, 1.0)(rng) < softShare)
            conditions.ground = randomSoftGround(rng);
        const auto more = driveOver(robot, ground, stopsOver(ground, 0.5), "",
                                    randomDriveStyle(rng), conditions, rng, skipped);
        for (const TwoTrackScene& scene : more)
            if (!isSymmetric(scene.s)) scenes.push_back(scene);
    }
    return scenes;
}

/// A change of the readings as a faulty sensor makes it.
struct Fault {
    const char* name;
    void (*apply)(TwoTrackReadings&);
};

constexpr double kFiveDegrees = 0.0873, kTenDegrees = 0.1745;
constexpr std::array kFaults{
    Fault{"no fault", [](TwoTrackReadings&) {}},
    Fault{"pitch 5 deg too large", [](TwoTrackReadings& s) { s.pitch += kFiveDegrees; }},
    Fault{"pitch 10 deg too large", [](TwoTrackReadings& s) { s.pitch += kTenDegrees; }},
    Fault{"pitch of the other sign", [](TwoTrackReadings& s) { s.pitch = -s.pitch; }},
    Fault{"roll 5 deg too large", [](TwoTrackReadings& s) { s.roll += kFiveDegrees; }},
    Fault{"roll 10 deg too large", [](TwoTrackReadings& s) { s.roll += kTenDegrees; }},
    Fault{"roll of the other sign", [](TwoTrackReadings& s) { s.roll = -s.roll; }},
    Fault{"front left flipper 10 deg up",
          [](TwoTrackReadings& s) { s.flippers[0] += kTenDegrees; }},
    Fault{"front left flipper of the other sign",
          [](TwoTrackReadings& s) { s.flippers[0] = -s.flippers[0]; }},
    Fault{"front flippers exchanged",
          [](TwoTrackReadings& s) { std::swap(s.flippers[0], s.flippers[1]); }},
    Fault{"front left current 0", [](TwoTrackReadings& s) { s.currents[0] = 0.0; }},
    Fault{"forces of both sides exchanged",
          [](TwoTrackReadings& s) { std::swap(s.forces[0], s.forces[1]); }},
};

struct Refusals {
    std::size_t refused = 0, unrested = 0, poses = 0;
    double seconds = 0.0;
};

Refusals check(const std::vector<TwoTrackScene>& scenes, const Fault& fault,
               const RobotModel& robot, const Models& models)
{
    Refusals found;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        Settings settings;
        settings.seed = 1 + k;
        TwoTrackReadings s = scenes[k].s;
        fault.apply(s);
        const TwoTrackEstimate estimate = estimateByBothSides(s, {}, robot, models, settings);
        const auto began = std::chrono::steady_clock::now();
        const TwoTrackCheck result = checkPosterior(estimate, s, robot);
        found.seconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        found.refused += result.agrees ? 0 : 1;
        found.unrested += result.rested == 0 ? 1 : 0;
        found.poses += static_cast<std::size_t>(result.rested);
    }
    return found;
}

}  // namespace
}  // namespace terratact

int main(int count, char** arguments)
{
    using namespace terratact;
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 2;
    const int drives = count > 2 ? std::atoi(arguments[2]) : 100;
    const bool generated = count <= 3;
    const RobotModel robot = absolem();
    const Models models(shippedModel(), robot);
    std::mt19937_64 rng(seed);
    const std::vector<GroundLines> grounds =
        generated ? generatedGround(robot, drives, rng) : groundOf(arguments[3], drives);
    const std::vector<TwoTrackScene> scenes =
        scenesOver(grounds, robot, generated ? 0.3 : 0.0, rng);
    const auto scenesCount = static_cast<double>(scenes.size());
    std::printf("%zu scenes that differ left and right\n%-38s %9s %8s %12s %6s %8s\n",
                scenes.size(), "fault", "refused", "share %", "no rest pose", "poses", "ms/scene");
    for (const Fault& fault : kFaults) {
        const Refusals found = check(scenes, fault, robot, models);
        std::printf("%-38s %9zu %8.2f %12zu %6.1f %8.1f\n", fault.name, found.refused,
                    100.0 * static_cast<double>(found.refused) / scenesCount, found.unrested,
                    static_cast<double>(found.poses) / scenesCount,
                    1000.0 * found.seconds / scenesCount);
    }
    return EXIT_SUCCESS;
}
