// Measures the simulator's cost per pose.
#include <benchmark/benchmark.h>

#include "core/sim/ground/random_ground.h"
#include "core/sim/rest/rest_pose.h"
#include "core/sim/rest/two_track_rest.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

void restPoseOnVariedGround(benchmark::State& state)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(1);
    const TerrainProfile terrain = randomVariedTerrain(rng);
    const auto stops = stopsOver(terrain, 0.05);
    std::size_t k = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            restPose(robot, terrain, stops[k++ % stops.size()], PressTorque{18.0}, HoldAngle{0.2}));
}
BENCHMARK(restPoseOnVariedGround)->Unit(benchmark::kMillisecond);

/// One pose of the generated mix.
struct MixedPose {
    GroundLines terrain;
    GroundOptions ground;
    double x = 0.0;
    FlipperDrive front, rear;
};

std::vector<MixedPose> mixedPoses(const RobotModel& robot)
{
    std::mt19937_64 rng(2);
    std::vector<MixedPose> poses;
    const std::vector<double> ys = groundYs(robot);
    for (int drive = 0; drive < 200; ++drive) {
        const GroundLines terrain = randomGround(randomGroundKind(rng), ys, rng);
        const DriveStyle style = randomDriveStyle(rng);
        const GroundOptions ground = drive % 10 < 3 ? randomSoftGround(rng) : GroundOptions{};
        for (const double x : stopsOver(terrain, 1.0))
            poses.push_back(
                {terrain, ground, x, PressTorque{style.pressTorque}, HoldAngle{style.rearAngle}});
    }
    return poses;
}

/// Poses of the generated mix, on the left track's line as one plane and on all lines.
void restPoseOnMixedGround(benchmark::State& state, bool twoTracks)
{
    const RobotModel robot = absolem();
    const std::vector<MixedPose> poses = mixedPoses(robot);
    std::size_t k = 0;
    for (auto _ : state) {
        const MixedPose& p = poses[k++ % poses.size()];
        if (twoTracks)
            benchmark::DoNotOptimize(
                restPose(robot, p.terrain, p.x, flipperDrives(p.front, p.rear), {}, p.ground));
        else
            benchmark::DoNotOptimize(restPose(robot, p.terrain.under(robot.lateral.trackY), p.x,
                                              p.front, p.rear, 0.0, p.ground));
    }
}
BENCHMARK_CAPTURE(restPoseOnMixedGround, plane, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(restPoseOnMixedGround, twoTracks, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace terratact
