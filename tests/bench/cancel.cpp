// Measures how long "cancel" waits for an estimate, for probe advice and for training. The wait is the longest work
// between two polls of the watch [ms of processor time]. It is measured in a first estimate, which factorises the
// model's processes, and in a later one. The first touch of a page of 2 MiB is measured, too. No poll can divide it,
// and a virtual machine may have to ask its host.
#include <benchmark/benchmark.h>
#include <cblas.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/atem/probe/arm_choice.h"
#include "core/infer/estimate/quality_preset.h"
#include "core/infer/estimator.h"
#include "core/infer/reconstruct.h"
#include "core/learn/gp/likelihood.h"
#include "core/learn/kernels/aligned_array.h"
#include "core/terrain/step.h"
#include "tests/bench/shipped_model.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

/// Returns processor time, so that other programs do not count.
double milliseconds()
{
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Returns the longest wait in one estimate [ms].
double longestWait(const std::function<void(const Watch&)>& estimate)
{
    double last = milliseconds();
    double longest = 0.0;
    const auto seen = [&] {
        const double now = milliseconds();
        longest = std::max(longest, now - last);
        last = now;
    };
    Watch watch;
    watch.cancelled = [&] {
        seen();
        return false;
    };
    estimate(watch);
    seen();
    return longest;
}

/// Variants of the estimate: the shipped model, or one with 5600 synthetic rows.
enum Load : int { Balanced, Accurate, AllChains, ManyRows, ManyDraws };
constexpr std::array kLoadNames{"balanced", "accurate", "64 chains", "5600 rows", "1e6 draws"};

Settings settingsFor(Method method, Load load)
{
    Settings settings = withPreset({.method = method}, QualityPreset::Balanced);
    if (load == Accurate) settings = withPreset(settings, QualityPreset::Accurate);
    if (load == AllChains) settings = {.method = method, .stopEarly = false, .chains = 64};
    if (load == ManyRows)
        settings = {.method = method, .draws = 128, .stopEarly = false, .chains = 64, .burnIn = 1};
    if (load == ManyDraws) {
        settings.draws = 1'000'000;
        settings.stopEarly = false;
    }
    return settings;
}

/// Returns the shipped model with its conditionals' rows repeated with a little noise.
ModelData manyRows(ModelData model)
{
    constexpr Eigen::Index kRows = 5600;
    std::mt19937_64 rng(1);
    std::normal_distribution<double> noise(0.0, 0.02);
    const Eigen::Index rows = model.scannedHeights.rows();
    const auto repeat = [&](Eigen::MatrixXd& X) {
        Eigen::MatrixXd more(kRows, X.cols());
        for (Eigen::Index u = 0; u < kRows; ++u)
            for (Eigen::Index d = 0; d < X.cols(); ++d) more(u, d) = X(u % rows, d) + noise(rng);
        X = std::move(more);
    };
    repeat(model.scannedHeights);
    repeat(model.features);
    return model;
}

using Estimate = std::function<void(const Watch&)>;

/// Returns an estimate with a fresh model.
Estimate estimateOf(const Scene& scene, const RobotModel& robot, const Settings& settings,
                    Load load)
{
    if (load == ManyRows) {
        auto models = std::make_shared<const BinModels>(manyRows(shippedModel()), FeatureSet::Paf);
        std::vector<ArmReading> arm;  // leaves three bins, each of which takes seconds
        for (int bin = 0; bin < 8; ++bin) arm.push_back({bin, -0.3, 0.03});
        return [=](const Watch& watch) {
            benchmark::DoNotOptimize(
                sampleScene(paperSampling(scene.s, arm, robot, *models, settings, watch), watch));
        };
    }
    auto models = std::make_shared<const Models>(shippedModel(), robot);
    return [=](const Watch& watch) {
        const TerrainEstimate estimate =
            estimateTerrain(scene.s, {}, robot, *models, settings, watch);
        benchmark::DoNotOptimize(adviseProbe(estimate, robot, kStepLimit, pollOf(watch)));
    };
}

void cancelWaits(benchmark::State& state)
{
    openblas_set_num_threads(1);
    const auto method = kSceneMethods[static_cast<std::size_t>(state.range(0))];
    const auto load = static_cast<Load>(state.range(1));
    const RobotModel robot = absolem();
    const Scene scene = someScenes(1, 7)[3];
    const Settings settings = settingsFor(method, load);
    double first = 0.0, later = 0.0;
    for (auto _ : state) {
        state.PauseTiming();
        const Estimate estimate = estimateOf(scene, robot, settings, load);
        state.ResumeTiming();
        first = std::max(first, longestWait(estimate));
        later = std::max(later, longestWait(estimate));
    }
    state.SetLabel(std::string(name(method)) + ", " + kLoadNames[static_cast<std::size_t>(load)]);
    state.counters["first_ms"] = first;
    state.counters["later_ms"] = later;
}

void loads(benchmark::internal::Benchmark* bench)
{
    for (std::size_t m = 0; m < kSceneMethods.size(); ++m)
        for (const Load load : {Balanced, Accurate, AllChains, ManyRows, ManyDraws}) {
            const bool closed = isClosedForm(kSceneMethods[m]);
            const bool sensible = load == ManyRows  ? kSceneMethods[m] == Method::Pafc
                                : load == ManyDraws ? closed
                                                    : !closed || load == Balanced;
            if (sensible) bench->Args({static_cast<long>(m), load});
        }
}

/// Measures one evaluation of a likelihood; a training makes many of them.
void cancelWaitsOfTraining(benchmark::State& state)
{
    openblas_set_num_threads(1);
    constexpr Eigen::Index kInputs = 22;
    const auto rows = static_cast<Eigen::Index>(state.range(0));
    std::mt19937_64 rng(1);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd X(rows, kInputs);
    for (double& x : X.reshaped()) x = normal(rng);
    Eigen::VectorXd y(rows);
    for (double& value : y) value = 0.1 * normal(rng);
    const Hyperparameters hyper{Eigen::VectorXd::Constant(kInputs, 4.0), 0.1, 0.03};
    const auto evaluate = [&](const Watch& watch) {
        benchmark::DoNotOptimize(negativeLogLikelihood(X, y, hyper, pollOf(watch)));
    };
    double first = 0.0, later = 0.0;
    for (auto _ : state) {
        first = longestWait(evaluate);
        later = longestWait(evaluate);
    }
    state.SetLabel("training, " + std::to_string(rows) + " rows");
    state.counters["first_ms"] = first;
    state.counters["later_ms"] = later;
}
BENCHMARK(cancelWaitsOfTraining)
    ->Arg(1400)
    ->Arg(5600)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// Returns the longest wait [ms] for `each` bytes that are written for the first time.
double longestTouch(char* fresh, std::size_t bytes, std::size_t each)
{
    constexpr std::size_t kPage = 4096;
    double longest = 0.0;
    for (std::size_t first = 0; first + each <= bytes; first += each) {
        const double before = milliseconds();
        for (std::size_t at = 0; at < each; at += kPage) fresh[first + at] = 1;
        benchmark::ClobberMemory();
        longest = std::max(longest, milliseconds() - before);
    }
    return longest;
}

/// Touches the bytes of a factorisation of 5600 rows, in pages of 2 MiB. Then it touches the bytes of a thousand draws
/// in blocks of 128 KiB, in pages of 4 KiB.
void touchesOfFreshPages(benchmark::State& state)
{
    constexpr std::size_t kBytes = 5600UL * 5600UL * sizeof(double);
    double huge = 0.0, small = 0.0;
    for (auto _ : state) {
        {
            AlignedArray<char> pages(kBytes, Unset{});
            huge = longestTouch(pages.data(), kBytes, kHugePage);
        }
        const std::unique_ptr<char[]> pages(new char[kBytes]);
        small = longestTouch(pages.get(), kBytes, std::size_t{1} << 17);
    }
    state.counters["2_MiB_ms"] = huge;
    state.counters["128_KiB_ms"] = small;
}
BENCHMARK(touchesOfFreshPages)->Iterations(1)->Unit(benchmark::kMillisecond);

BENCHMARK(cancelWaits)->Apply(loads)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace terratact
