// Measures training's likelihood and gradient, on data of another program or over a range of sizes.
//   terratact-bench-likelihood data FILE REPEATS   CPU ms of the fastest of REPEATS, the value, the gradient
//   terratact-bench-likelihood growth U...         CPU ms and memory per size, in increasing order, and the exponents
//   terratact-bench-likelihood train SCENES ROWS   seconds for the paper's 22 processes, on all cores
//   terratact-bench-likelihood sparse SCENES ROWS TEST BIN M...
//       one bin's process, exact and through M rows: CPU s to make it, errors on the scenes of TEST; then exact
//       with hyperparameters searched on all rows: ten minutes for 11200 rows
// FILE: 64-bit little-endian: U, d (integers); X row by row, y, ℓ, σ_f, σ_n (doubles).
// All except train use one thread. Results depend on the machine; training.sh runs all of them.
#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "app/runtime/parallel.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/gp/likelihood.h"
#include "core/learn/gp/scene_conditional.h"
#include "core/learn/model/bin_models.h"
#include "core/learn/model/training.h"

extern "C" void openblas_set_num_threads(int);

namespace terratact {
namespace {

struct Problem {
    Eigen::MatrixXd X;
    Eigen::VectorXd y;
    Hyperparameters hyper;
};

Eigen::VectorXd readNumbers(std::ifstream& file, std::int64_t count)
{
    Eigen::VectorXd values(count);
    file.read(reinterpret_cast<char*>(values.data()), count * 8);
    return values;
}

Problem readProblem(const char* path)
{
    std::ifstream file(path, std::ios::binary);
    std::int64_t size[2] = {};
    file.read(reinterpret_cast<char*>(size), sizeof size);
    if (!file || size[0] < 1 || size[1] < 1) std::exit(1);
    Problem p;
    const Eigen::VectorXd x = readNumbers(file, size[0] * size[1]);
    p.X = Eigen::Map<const Eigen::MatrixXd>(x.data(), size[1], size[0]).transpose();
    p.y = readNumbers(file, size[0]);
    p.hyper.lengthScale = readNumbers(file, size[1]);
    const Eigen::VectorXd sd = readNumbers(file, 2);
    p.hyper.signalSd = sd[0];
    p.hyper.noiseSd = sd[1];
    if (!file) std::exit(1);
    return p;
}

Problem someProblem(int U)
{
    constexpr int d = 22;
    std::mt19937_64 rng(1);
    std::normal_distribution<double> normal;
    Problem p{Eigen::MatrixXd(U, d),
              Eigen::VectorXd(U),
              {Eigen::VectorXd::LinSpaced(d, 2.0, 9.0), 0.1, 0.02}};
    for (double& x : p.X.reshaped()) x = normal(rng);
    for (Eigen::Index u = 0; u < U; ++u) p.y[u] = 0.1 * std::sin(p.X(u, 0)) + 0.02 * normal(rng);
    return p;
}

double milliseconds(clockid_t clock = CLOCK_THREAD_CPUTIME_ID)
{
    timespec t{};
    clock_gettime(clock, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

double fastest(const Problem& p, int repeats, Likelihood& value)
{
    double best = std::numeric_limits<double>::infinity();
    for (int r = 0; r < repeats; ++r) {
        const double start = milliseconds();
        value = negativeLogLikelihood(p.X, p.y, p.hyper);
        best = std::min(best, milliseconds() - start);
    }
    return best;
}

/// Returns the peak resident size so far, so sizes must increase.
double peakKilobytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss);
}

/// Returns the slope of log y over log x by least squares.
double exponent(const std::vector<double>& x, const std::vector<double>& y)
{
    const auto n = static_cast<Eigen::Index>(x.size());
    const Eigen::ArrayXd a = Eigen::Map<const Eigen::ArrayXd>(x.data(), n).log();
    const Eigen::ArrayXd b = Eigen::Map<const Eigen::ArrayXd>(y.data(), n).log();
    return ((a - a.mean()) * (b - b.mean())).sum() / (a - a.mean()).square().sum();
}

void growth(const std::vector<int>& sizes)
{
    std::vector<double> U;
    std::vector<double> cpu;
    const double before = peakKilobytes();
    std::printf("%8s %12s %14s %10s\n", "rows", "cpu_ms", "peak_doubles", "per_U2");
    for (const int size : sizes) {
        const Problem p = someProblem(size);
        Likelihood value;
        cpu.push_back(fastest(p, size < 2000 ? 5 : (size < 6000 ? 2 : 1), value));
        U.push_back(size);
        const double doubles = (peakKilobytes() - before) * 128.0;
        std::printf("%8d %12.2f %14.0f %10.2f\n", size, cpu.back(), doubles,
                    doubles / (U.back() * U.back()));
        std::fflush(stdout);
    }
    if (U.size() < 2) return;
    const std::size_t k = U.size() - 1;
    std::printf("time grows as U^%.2f over all sizes, U^%.2f between the last two\n",
                exponent(U, cpu), std::log(cpu[k] / cpu[k - 1]) / std::log(U[k] / U[k - 1]));
}

void data(const char* path, int repeats)
{
    const Problem p = readProblem(path);
    Likelihood value;
    const double best = fastest(p, repeats, value);
    std::printf("%.3f %.17g", best, value.negativeLog);
    for (const double g : value.gradient) std::printf(" %.17g", g);
    std::printf("\n");
}

std::vector<Scene> scenesOf(const char* path)
{
    auto file = readScenes(path);
    if (!file) {
        std::fprintf(stderr, "%s\n", file.error().text.c_str());
        std::exit(1);
    }
    return std::move(file->scenes);
}

void train(const char* path, int rows)
{
    const ModelData model =
        prepareTraining(scenesOf(path), {.conditionalRows = rows, .scannerSd = 0.012}).model;
    std::vector<TrainedBin> trained(2 * kBins);
    const double start = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    const double began = milliseconds(CLOCK_MONOTONIC);
    parallelFor(2 * kBins, [&](int job) {
        const FeatureSet set = job < kBins ? FeatureSet::Paf : FeatureSet::Pa;
        trained[static_cast<std::size_t>(job)] = trainBin(model, set, job % kBins, {});
    });
    const double cpu = 1e-3 * (milliseconds(CLOCK_PROCESS_CPUTIME_ID) - start);
    const double wall = 1e-3 * (milliseconds(CLOCK_MONOTONIC) - began);
    double sum = 0.0;
    for (const TrainedBin& bin : trained) sum += bin.logLikelihood;
    std::printf("22 Gaussian processes on %d rows: %.1f s, %.1f CPU s, sum of log p(y|X) %.1f\n",
                static_cast<int>(model.scannedHeights.rows()), wall, cpu, sum);
}

/// Returns the root mean square error of a bin's predictions for complete scenes.
double error(const BinModels& models, int bin, int inducing, const std::vector<Scene>& scenes)
{
    std::vector<Eigen::VectorXd> x;
    std::vector<double> truth;
    for (const Scene& scene : scenes) {
        if (!isComplete(scene)) continue;
        Heights h{};
        for (std::size_t i = 0; i < kBins; ++i) h[i] = *scene.truth[i];
        x.push_back(models.input(bin, h, features(FeatureSet::Paf, scene.s)));
        truth.push_back(h[static_cast<std::size_t>(bin)]);
    }
    Eigen::MatrixXd inputs(x.front().size(), static_cast<Eigen::Index>(x.size()));
    for (std::size_t k = 0; k < x.size(); ++k) inputs.col(static_cast<Eigen::Index>(k)) = x[k];
    std::vector<int> all(static_cast<std::size_t>(inputs.rows()));
    std::iota(all.begin(), all.end(), 0);
    Eigen::VectorXd mean, variance;
    SceneConditional(models.bin(bin, inducing), x.front(), all, Precision::Double)
        .predict(inputs, mean, variance);
    const Eigen::Map<const Eigen::VectorXd> known(truth.data(), mean.size());
    return std::sqrt((mean - known).squaredNorm() / static_cast<double>(mean.size()));
}

/// Searches hyperparameters on `searched` rows (0: all), then predicts through several numbers of rows.
void sparse(ModelData model, int searched, const std::vector<Scene>& scenes, int bin,
            const std::vector<int>& sizes)
{
    double start = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    TrainingOptions options;
    options.fullRows = searched;
    const auto i = static_cast<std::size_t>(bin);
    model.paf.bins[i] = trainBin(model, FeatureSet::Paf, bin, options).hyper;
    const auto rows = static_cast<int>(model.scannedHeights.rows());
    std::printf("search on %d of %d rows: %.1f CPU s\n", searched > 0 ? searched : rows, rows,
                1e-3 * (milliseconds(CLOCK_PROCESS_CPUTIME_ID) - start));
    const BinModels models(model, FeatureSet::Paf);
    for (const int m : sizes) {
        start = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
        const auto used = static_cast<int>(models.bin(bin, m).rows());
        const double cpu = 1e-3 * (milliseconds(CLOCK_PROCESS_CPUTIME_ID) - start);
        std::printf("through %5d rows: made in %6.2f CPU s, error %.5f m\n", used, cpu,
                    error(models, bin, m, scenes));
        std::fflush(stdout);
    }
}

void sparse(const char* path, int rows, const char* test, int bin, const std::vector<int>& sizes)
{
    const ModelData model =
        prepareTraining(scenesOf(path), {.conditionalRows = rows, .scannerSd = 0.012}).model;
    const std::vector<Scene> scenes = scenesOf(test);
    sparse(model, kRowsOfSparseSearch, scenes, bin, sizes);
    sparse(model, 0, scenes, bin, {0});
}

/// Prints every bin's error through several numbers of rows, relative to that through all rows, with one common search.
void sparseBins(const char* path, int rows, const char* test, const std::vector<int>& sizes)
{
    const ModelData model =
        prepareTraining(scenesOf(path), {.conditionalRows = rows, .scannerSd = 0.012}).model;
    const std::vector<Scene> scenes = scenesOf(test);
    constexpr int kAtOnce = 2;  // bounds memory: each takes 1.5 times the square of all rows
    std::vector<std::vector<double>> errors(kBins);
    parallelFor(
        kBins,
        [&](int bin) {
            ModelData own = model;
            TrainingOptions options;
            options.fullRows = kRowsOfSparseSearch;
            const auto i = static_cast<std::size_t>(bin);
            own.paf.bins[i] = trainBin(own, FeatureSet::Paf, bin, options).hyper;
            errors[i].push_back(error(BinModels(own, FeatureSet::Paf), bin, 0, scenes));
            for (const int m : sizes)
                errors[i].push_back(error(BinModels(own, FeatureSet::Paf), bin, m, scenes));
        },
        kAtOnce);
    std::printf("%6s %10s", "bin", "all rows");
    for (const int m : sizes) std::printf(" %10d", m);
    std::printf("\n");
    for (int bin = 0; bin < kBins; ++bin) {
        const std::vector<double>& of = errors[static_cast<std::size_t>(bin)];
        std::printf("%6d %8.5f m", bin, of.front());
        for (std::size_t k = 1; k < of.size(); ++k) std::printf(" %10.3f", of[k] / of.front());
        std::printf("\n");
    }
}

}  // namespace
}  // namespace terratact

int main(int argc, char** argv)
{
    openblas_set_num_threads(1);
    if (argc == 4 && std::strcmp(argv[1], "data") == 0) {
        terratact::data(argv[2], std::atoi(argv[3]));
        return 0;
    }
    if (argc >= 3 && std::strcmp(argv[1], "growth") == 0) {
        std::vector<int> sizes;
        for (int k = 2; k < argc; ++k) sizes.push_back(std::max(1, std::atoi(argv[k])));
        terratact::growth(sizes);
        return 0;
    }
    if (argc == 4 && std::strcmp(argv[1], "train") == 0) {
        terratact::train(argv[2], std::atoi(argv[3]));
        return 0;
    }
    if (argc >= 7 && std::strcmp(argv[1], "sparse") == 0) {
        std::vector<int> sizes;
        for (int k = 6; k < argc; ++k) sizes.push_back(std::max(0, std::atoi(argv[k])));
        terratact::sparse(argv[2], std::atoi(argv[3]), argv[4], std::atoi(argv[5]), sizes);
        return 0;
    }
    if (argc >= 6 && std::strcmp(argv[1], "sparse-bins") == 0) {
        std::vector<int> sizes;
        for (int k = 5; k < argc; ++k) sizes.push_back(std::max(1, std::atoi(argv[k])));
        terratact::sparseBins(argv[2], std::atoi(argv[3]), argv[4], sizes);
        return 0;
    }
    std::fprintf(stderr,
                 "usage: %s data FILE REPEATS | growth U... | train ... | sparse ... | "
                 "sparse-bins ...\n",
                 argv[0]);
    return 2;
}
