// Measures the limits of the sampler: processor peak, quadratic form, sweeps, one scene, one draw. tests/bench/run.sh
// runs it alternately with tests/bench/peer_numpy.py.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/infer/estimate/quality_preset.h"
#include "core/infer/estimate_batch.h"
#include "core/infer/estimator.h"
#include "core/infer/reconstruct.h"
#include "core/infer/reconstruct_clearance.h"
#include "core/infer/sampling/gibbs.h"
#include "core/infer/sampling/process_scene.h"
#include "core/learn/gp/likelihood.h"
#include "core/terrain/body_ceiling.h"
#include "tests/bench/fma_peak.h"
#include "tests/bench/shipped_model.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

constexpr int kSweeps = 20;
constexpr std::size_t kAhead = 8;  // a bin ahead of the robot

const BinModels& shippedBins()
{
    static const BinModels models(shippedModel(), FeatureSet::Paf);
    return models;
}

const Scene& someScene()
{
    static const Scene scene = someScenes(1, 7)[3];
    return scene;
}

/// BinConditionals with the kernels of one instruction set.
class KernelConditionals final : public Conditionals {
public:
    KernelConditionals(const CovarianceKernels& kernels, Precision precision)
        : kernels_(kernels), precision_(precision)
    {
    }
    StartDraw start(int bin) const override
    {
        return {shippedBins().heightMean(bin), shippedBins().heightSd(bin)};
    }
    std::unique_ptr<SceneConditionals> at(const Heights& known,
                                          const std::vector<int>& unknown) const override
    {
        auto scene = std::make_unique<ProcessScene>();
        const Eigen::VectorXd s = features(FeatureSet::Paf, someScene().s);
        for (const int i : unknown)
            scene->add(std::make_unique<SceneConditional>(
                           shippedBins().bin(i), shippedBins().input(i, known, s),
                           movingInputs(unknown, i), precision_, Poll{}, kernels_),
                       shippedBins().heightMean(i), shippedBins().heightSd(i));
        return scene;
    }

private:
    const CovarianceKernels& kernels_;
    Precision precision_;
};

/// Returns the share of products with all rows that remain in single precision, averaged over nine unknown bins.
double productsLeft(const GibbsProblem& problem)
{
    double left = 0.0;
    int bins = 0;
    for (int bin = 0; bin < static_cast<int>(kBins); ++bin) {
        if (problem.known[static_cast<std::size_t>(bin)]) continue;
        const GaussianProcess& gp = shippedBins().bin(bin);
        const double share = gp.varianceRows() / static_cast<double>(gp.rows());
        left += share * share;
        ++bins;
    }
    return left / bins;
}

/// Returns a problem with nine unknown bins under the robot's ceilings.
GibbsProblem nineUnknown(int chains)
{
    const Scene& scene = someScene();
    GibbsProblem problem;
    problem.known[7] = scene.truth[7];
    problem.known[8] = scene.truth[8];
    problem.ceiling = bodyCeiling(absolem(), scene.s.pitch, scene.s.front, scene.s.rear);
    problem.chains = chains;
    problem.burnIn = 0;
    problem.keptPerChain = kSweeps;
    return problem;
}

/// Measures per chain-sweep; the set-up of a scene is shared by kSweeps sweeps.
void sweep(benchmark::State& state, const CovarianceKernels& kernels, Precision precision)
{
    const int chains = static_cast<int>(state.range(0));
    const KernelConditionals conditionals(kernels, precision);
    const GibbsProblem problem = nineUnknown(chains);
    benchmark::DoNotOptimize(sampleStates(conditionals, problem));  // packs the rows
    for (auto _ : state) benchmark::DoNotOptimize(sampleStates(conditionals, problem));
    state.counters["s_per_chain_sweep"] = benchmark::Counter(
        static_cast<double>(chains) * kSweeps,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["products_left"] = precision == Precision::Single ? productsLeft(problem) : 1.0;
}

template <class T>
void quadraticForm(benchmark::State& state, const CovarianceKernels& kernels)
{
    constexpr int U = 1400;
    const int groups = static_cast<int>(state.range(0)) / kGroup;
    AlignedArray<T> panels(static_cast<std::size_t>(panelStart<T>(paddedRows(U))));
    AlignedArray<T> K(static_cast<std::size_t>(groups * paddedRows(U) * kGroup));
    AlignedArray<double> out(static_cast<std::size_t>(groups * kGroup));
    for (std::size_t k = 0; k < panels.size(); ++k) panels.data()[k] = T(0.01);
    for (std::size_t k = 0; k < K.size(); ++k) K.data()[k] = T(0.01);
    for (auto _ : state) {
        if constexpr (sizeof(T) == sizeof(float))
            kernels.sumsOfSquaresSingle(panels.data(), K.data(), U, groups, out.data(), {});
        else
            kernels.sumsOfSquares(panels.data(), K.data(), U, groups, out.data(), {});
        benchmark::ClobberMemory();
    }
    state.counters["flops"] = benchmark::Counter(static_cast<double>(U) * (U + 1) * groups * kGroup,
                                                 benchmark::Counter::kIsIterationInvariantRate);
}

/// Measures one group of columns at a bin with eight moving inputs.
void covariances(benchmark::State& state, const CovarianceKernels& kernels)
{
    constexpr int U = 1400;
    constexpr int m = 8;
    AlignedArray<double> X(U * m), perLength(m), logWeight(U), alpha(U), Z(m * kGroup),
        mean(kGroup);
    AlignedArray<float> K(static_cast<std::size_t>(paddedRows(U) * kGroup));
    const CovarianceInput in{X.data(), perLength.data(), logWeight.data(), alpha.data(), U, U, m,
                             1.0};
    for (auto _ : state) {
        kernels.covariancesSingle(in, Z.data(), K.data(), mean.data());
        benchmark::ClobberMemory();
    }
}

void peak(benchmark::State& state, double (*flops)(int))
{
    double total = 0.0;
    for (auto _ : state) total += flops(10000);
    state.counters["flops"] = benchmark::Counter(total, benchmark::Counter::kIsRate);
}

/// Measures one scene: K = 1000 kept draws in 16 chains, burn-in 50 sweeps, nine unknown bins.
void oneScene(benchmark::State& state, Precision precision)
{
    const RobotModel robot = absolem();
    const Scene& scene = someScene();
    Settings settings;
    settings.method = Method::Pafc;
    settings.precision = precision;
    settings.forceThreshold = 1000.0;  // no contact, so only the two bins below the robot are known
    const std::vector<ArmReading> known{{7, *scene.truth[7], 0.03}, {8, *scene.truth[8], 0.03}};
    const auto run = [&] {
        return sampleScene(paperSampling(scene.s, known, robot, shippedBins(), settings));
    };
    benchmark::DoNotOptimize(run());
    for (auto _ : state) benchmark::DoNotOptimize(run());
}

void oneClearanceScene(benchmark::State& state)
{
    const RobotModel robot = absolem();
    ClearanceTraining training = clearanceTraining(shippedModel(), robot);
    ClearanceConditionalData data = clearanceConditionalData(shippedModel(), training);
    const ClearanceConditionals models(std::move(training), std::move(data));
    Settings settings;
    settings.method = Method::Clearance;
    const auto run = [&] {
        return sampleScene(clearanceSampling(someScene().s, {}, robot, models, settings));
    };
    benchmark::DoNotOptimize(run());
    for (auto _ : state) benchmark::DoNotOptimize(run());
}
BENCHMARK(oneClearanceScene)->Unit(benchmark::kMillisecond);

/// Measures one complete scene at the preset balanced, among those the method can estimate. PAFAc gets one arm reading
/// ahead of the robot.
void oneBalancedScene(benchmark::State& state, Method method)
{
    static const Models models(shippedModel(), absolem());
    static const std::vector<Scene> all = someScenes(16, 7);
    Settings settings = withPreset({}, QualityPreset::Balanced);
    settings.method = method;
    settings.stopEarly = false;  // takes all its draws
    const RobotModel robot = absolem();
    const auto run = [&](const Scene& scene) {
        std::vector<ArmReading> arm;
        if (method == Method::Pafac)
            arm.push_back({kAhead, scene.truth[kAhead].value_or(0.0), 0.03});
        return estimateTerrain(scene.s, arm, robot, models, settings);
    };
    std::vector<Scene> some;
    for (const Scene& scene : all) {
        try {
            benchmark::DoNotOptimize(run(scene));
            some.push_back(scene);
        } catch (const NotLearnt&) {
        }
    }
    std::size_t next = 0;
    for (auto _ : state) benchmark::DoNotOptimize(run(some[next++ % some.size()]));
}

/// Measures scenes of an evaluation by one of the paper's methods, through EstimateBatch or one by one. There are twice
/// as many as fit into a batch (at most 64), each with its own known bins. Result per chain-sweep, all else included.
void scenes(benchmark::State& state, Settings settings, bool batched)
{
    const RobotModel robot = absolem();
    static const Models models(shippedModel(), robot);
    static const std::vector<Scene> all = someScenes(16, 7);
    settings.method = Method::Pafc;
    settings.stopEarly = false;
    settings.burnIn = 0;
    settings.draws = kSweeps * settings.chains;
    const auto count = static_cast<std::size_t>(std::clamp(128 / settings.chains, 2, 64));
    const auto some = std::span(all).first(count);
    const std::size_t atOnce =
        batched ? static_cast<std::size_t>(std::max(1, kBatchChains / settings.chains)) : 1;
    const auto run = [&] {
        EstimateBatch batch(robot, models);
        std::size_t next = 0;
        std::size_t inWork = 0;
        while (next < some.size() || inWork > 0) {
            for (; next < some.size() && inWork < atOnce; ++next, ++inWork)
                batch.add(next, some[next].s, {}, settings);
            inWork -= batch.next().size();
        }
    };
    run();
    for (auto _ : state) run();
    state.counters["s_per_chain_sweep"] = benchmark::Counter(
        static_cast<double>(some.size()) * settings.chains * kSweeps,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

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
    const Eigen::VectorXd y = model.heights.col(5).head(X.rows()).array() - model.paf.mean[5];
    for (auto _ : state) benchmark::DoNotOptimize(negativeLogLikelihood(X, y, model.paf.bins[5]));
}
BENCHMARK(likelihoodAndGradient)->Unit(benchmark::kMillisecond);

void add(const std::string& name, const std::function<void(benchmark::State&)>& run,
         std::initializer_list<std::int64_t> arguments)
{
    auto* registered = benchmark::RegisterBenchmark(name.c_str(), run);
    for (const std::int64_t argument : arguments) registered->Arg(argument);
}

void registerKernels(const CovarianceKernels& kernels)
{
    std::string suffix = "/";
    suffix += kernels.name;
    const FmaPeak& fma = fmaPeak(kernels.name);
    add("peak" + suffix + "/f32", [&fma](benchmark::State& s) { peak(s, fma.single); }, {});
    add("peak" + suffix + "/f64", [&fma](benchmark::State& s) { peak(s, fma.full); }, {});
    add("quadratic" + suffix + "/f32",
        [&kernels](benchmark::State& s) { quadraticForm<float>(s, kernels); }, {8, 16, 64});
    add("quadratic" + suffix + "/f64",
        [&kernels](benchmark::State& s) { quadraticForm<double>(s, kernels); }, {8, 16, 64});
    add("covariances" + suffix, [&kernels](benchmark::State& s) { covariances(s, kernels); }, {});
    add("sweep" + suffix + "/f32",
        [&kernels](benchmark::State& s) { sweep(s, kernels, Precision::Single); }, {1, 8, 16, 64});
    add("sweep" + suffix + "/f64",
        [&kernels](benchmark::State& s) { sweep(s, kernels, Precision::Double); }, {1, 8, 16, 64});
}

void registerAll()
{
    int count = 0;
    const auto* kernels = availableCovarianceKernels(count);
    for (int k = 0; k < count; ++k) registerKernels(*kernels[k]);
    const auto evaluation = [](const std::string& name, const Settings& settings) {
        for (const bool batched : {false, true})
            add("scenes/" + name + (batched ? "/batched" : "/alone"),
                [=](benchmark::State& s) { scenes(s, settings, batched); }, {});
    };
    for (const int chains : {1, 4, 8, 16}) {
        Settings settings;
        settings.chains = chains;
        evaluation(std::to_string(chains) + " chains", settings);
    }
    for (const int inducing : {175, 300, 700}) {
        Settings settings;
        settings.inducing = inducing;
        evaluation(std::to_string(inducing) + " rows", settings);
    }
    for (const QualityPreset preset : kQualityPresets)
        evaluation(std::string(name(preset)), withPreset({}, preset));
    for (const Method method : kSceneMethods)
        add("oneBalancedScene/" + std::string(name(method)),
            [=](benchmark::State& s) { oneBalancedScene(s, method); }, {});
    add("oneScene/f32", [](benchmark::State& s) { oneScene(s, Precision::Single); }, {});
    add("oneScene/f64", [](benchmark::State& s) { oneScene(s, Precision::Double); }, {});
}

}  // namespace
}  // namespace terratact

int main(int argc, char** argv)
{
    terratact::registerAll();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
