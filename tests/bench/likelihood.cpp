// What training's likelihood and gradient cost, on data of another program or over a range of sizes.
//   terratact-bench-likelihood data FILE REPEATS   CPU ms of the fastest of REPEATS, the value, the gradient
//   terratact-bench-likelihood growth U...         CPU ms and memory per size, and the exponents
// FILE: 64-bit little-endian: U, d (integers); X row by row, y, ℓ, σ_f, σ_n (doubles).
// One thread.  Figures are of this machine and this moment.
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
#include <random>
#include <string>
#include <vector>

#include "core/learn/covariance_kernels.h"
#include "core/learn/likelihood.h"

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

double cpuMilliseconds()
{
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

double fastest(const Problem& p, int repeats, Likelihood& value)
{
    double best = std::numeric_limits<double>::infinity();
    for (int r = 0; r < repeats; ++r) {
        const double start = cpuMilliseconds();
        value = negativeLogLikelihood(p.X, p.y, p.hyper);
        best = std::min(best, cpuMilliseconds() - start);
    }
    return best;
}

/// Doubles that one evaluation adds to the largest resident size so far; sizes must grow.
double peakKilobytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss);
}

/// Slope of log y over log x by least squares.
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
    std::printf("%8s %12s %14s %10s\n", "rows", "cpu_ms", "peak_doubles", "per_U2");
    for (const int size : sizes) {
        const Problem p = someProblem(size);
        const double before = peakKilobytes();
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
    std::fprintf(stderr, "usage: %s data FILE REPEATS | growth U...\n", argv[0]);
    return 2;
}
