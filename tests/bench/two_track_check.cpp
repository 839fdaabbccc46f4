// Measures the posterior check of both sides on fault-free simulated scenes: the share that it refuses, and its
// cost. Arguments: seed, drives.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "core/atem/arm_choice.h"
#include "core/infer/two_track_estimator.h"
#include "core/robot/side_plane.h"
#include "core/sim/ground/random_ground.h"
#include "core/sim/two_track_check.h"
#include "core/sim/two_track_drive.h"
#include "tests/bench/shipped_model.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

std::vector<TwoTrackScene> scenesOf(const RobotModel& robot, std::uint64_t seed, int drives)
{
    std::mt19937_64 rng(seed);
    std::vector<TwoTrackScene> scenes;
    int skipped = 0;
    for (int drive = 0; drive < drives; ++drive) {
        const GroundLines ground = randomGround(randomGroundKind(rng), groundYs(robot), rng);
        DriveConditions conditions;
        if (drive % 10 < 3) conditions.ground = randomSoftGround(rng);
        const auto more = driveOver(robot, ground, stopsOver(ground, 0.5), std::to_string(drive),
                                    randomDriveStyle(rng), conditions, rng, skipped);
        scenes.insert(scenes.end(), more.begin(), more.end());
    }
    return scenes;
}

struct Refusals {
    std::size_t scenes = 0, refused = 0, unrested = 0, poses = 0;
    double seconds = 0.0, adviceSeconds = 0.0;
};

void check(const std::vector<TwoTrackScene>& scenes, const RobotModel& robot, const Models& models,
           Refusals& found)
{
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        if (isSymmetric(scenes[k].s)) continue;
        Settings settings;
        settings.seed = 1 + k;
        const TwoTrackEstimate estimate =
            estimateByBothSides(scenes[k].s, {}, robot, models, settings);
        const auto began = std::chrono::steady_clock::now();
        const TwoTrackCheck result = checkPosterior(estimate, scenes[k].s, robot);
        found.seconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        const auto checked = std::chrono::steady_clock::now();
        (void)adviseProbe(estimate, robot, 0.1);
        found.adviceSeconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - checked).count();
        ++found.scenes;
        found.refused += result.agrees ? 0 : 1;
        found.unrested += result.rested == 0 ? 1 : 0;
        found.poses += static_cast<std::size_t>(result.rested);
        if (!result.agrees)
            std::printf("refused: pitch %+.2f on its ground %+.2f, roll %+.2f on its ground %+.2f, "
                        "front %+.2f %+.2f on its ground %+.2f %+.2f\n",
                        scenes[k].s.pitch, result.pitch, scenes[k].s.roll, result.roll,
                        scenes[k].s.flippers[0], scenes[k].s.flippers[1], result.front[0],
                        result.front[1]);
    }
}

}  // namespace
}  // namespace terratact

int main(int count, char** arguments)
{
    using namespace terratact;
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 2;
    const int drives = count > 2 ? std::atoi(arguments[2]) : 100;
    const RobotModel robot = absolem();
    const Models models(shippedModel(), robot);
    Refusals found;
    check(scenesOf(robot, seed, drives), robot, models, found);
    const auto each = [&found](double all) { return all / static_cast<double>(found.scenes); };
    std::printf(
        "%zu scenes, %zu refused (%.2f %%), %zu without a rest pose; a scene takes %.1f poses in "
        "%.1f ms, and %.0f ms for the advice of a probe\n",
        found.scenes, found.refused, 100.0 * each(static_cast<double>(found.refused)),
        found.unrested, each(static_cast<double>(found.poses)), 1000.0 * each(found.seconds),
        1000.0 * each(found.adviceSeconds));
    return EXIT_SUCCESS;
}
