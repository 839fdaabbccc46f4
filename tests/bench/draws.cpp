// Measures the cost of one truncated normal draw [ns]; bounds are in deviations from the mean.
#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>

#include "core/infer/sampling/truncated_normal.h"

namespace terratact {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void draws(benchmark::State& state, double floor, double ceiling)
{
    std::mt19937_64 rng(1);
    for (auto _ : state) benchmark::DoNotOptimize(drawBetween(floor, ceiling, 0.0, 1.0, rng));
}

void drawsBelow(benchmark::State& state, double ceiling)
{
    std::mt19937_64 rng(1);
    for (auto _ : state) benchmark::DoNotOptimize(drawBelow(ceiling, 0.0, 1.0, rng));
}

BENCHMARK_CAPTURE(drawsBelow, free, kInfinity);
BENCHMARK_CAPTURE(drawsBelow, at_plus_1, 1.0);
BENCHMARK_CAPTURE(drawsBelow, at_0, 0.0);
BENCHMARK_CAPTURE(drawsBelow, at_minus_0_1, -0.1);
BENCHMARK_CAPTURE(drawsBelow, at_minus_2, -2.0);
BENCHMARK_CAPTURE(drawsBelow, at_minus_38, -38.0);
BENCHMARK_CAPTURE(drawsBelow, at_minus_1e8, -1e8);
BENCHMARK_CAPTURE(draws, from_minus_1_to_3, -1.0, 3.0);
BENCHMARK_CAPTURE(draws, from_minus_0_1_to_0_1, -0.1, 0.1);
BENCHMARK_CAPTURE(draws, from_0_to_2_49, 0.0, 2.49);
BENCHMARK_CAPTURE(draws, from_minus_2_to_minus_1, -2.0, -1.0);
BENCHMARK_CAPTURE(draws, from_8_to_8_3, 8.0, 8.3);

}  // namespace
}  // namespace terratact
