// What the parts cost.  build/release/tests/terratact-bench; figures are of this machine and this moment.
#include <benchmark/benchmark.h>

#include "core/infer/reconstruct.h"
#include "core/learn/likelihood.h"
#include "core/learn/model_file.h"
#include "core/sim/rest_pose.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

const ModelData& shippedModel()
{
    static const ModelData model = [] {
        auto stored = readModel(TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
        if (!stored) throw std::runtime_error(stored.error().text);
        return stored->data;
    }();
    return model;
}

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

void factoriseOneBin(benchmark::State& state)
{
    for (auto _ : state) {
        const BinModels models(shippedModel(), FeatureSet::Paf);
        benchmark::DoNotOptimize(models.bin(5).rows());
    }
}
BENCHMARK(factoriseOneBin)->Unit(benchmark::kMillisecond);

void likelihoodAndGradient(benchmark::State& state)
{
    const ModelData& model = shippedModel();
    const Eigen::MatrixXd X = withoutBin(
        standardised(rawInputs(model, FeatureSet::Paf), model.paf.mean, model.paf.sd), 5);
    const Eigen::VectorXd y = model.heights.col(5).array() - model.paf.mean[5];
    for (auto _ : state) benchmark::DoNotOptimize(negativeLogLikelihood(X, y, model.paf.bins[5]));
}
BENCHMARK(likelihoodAndGradient)->Unit(benchmark::kMillisecond);

/// One scene: K = 1000 kept draws in `chains` chains with burn-in, nine unknown bins, U = 1400.
void oneScene(benchmark::State& state)
{
    const RobotModel robot = absolem();
    const BinModels models(shippedModel(), FeatureSet::Paf);
    for (int i = 0; i < kBins; ++i) benchmark::DoNotOptimize(models.bin(i).rows());
    const Scene scene = someScenes(1, 7)[3];
    Settings settings;
    settings.forceThreshold = 1000.0;  // no contact: the two bins below are all that is known
    settings.chains = static_cast<int>(state.range(0));
    const std::vector<ArmReading> known{{7, *scene.truth[7], 0.03}, {8, *scene.truth[8], 0.03}};
    for (auto _ : state)
        benchmark::DoNotOptimize(reconstruct(scene.s, known, robot, models, settings));
}
BENCHMARK(oneScene)->Arg(8)->Arg(16)->Arg(32)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace terratact

BENCHMARK_MAIN();
