// Measures the simulator's cost per pose.
#include <benchmark/benchmark.h>

#include "core/sim/rest_pose.h"
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

}  // namespace
}  // namespace terratact
