// How long an estimate makes a "cancel" wait: the longest work between two questions of its watch [ms of
// processor time], from the very first estimate with a model (its Gaussian processes are factorised on the
// way) and from a later one.
#include <benchmark/benchmark.h>
#include <cblas.h>

#include <algorithm>
#include <ctime>
#include <string>

#include "core/infer/estimator.h"
#include "core/learn/model_file.h"
#include "tests/support/toy_model.h"

namespace terratact {
namespace {

/// Processor time: other programs do not count.
double milliseconds()
{
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The longest wait in one estimate [ms].
double longestWait(const Scene& scene, const RobotModel& robot, const Models& models,
                   const Settings& settings)
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
    benchmark::DoNotOptimize(estimateTerrain(scene.s, {}, robot, models, settings, watch));
    seen();
    return longest;
}

void cancelWaits(benchmark::State& state)
{
    openblas_set_num_threads(1);
    const RobotModel robot = absolem();
    const auto stored = readModel(TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
    if (!stored) throw std::runtime_error(stored.error().text);
    const Scene scene = someScenes(1, 7)[3];
    Settings settings;
    settings.method = kMethods[static_cast<std::size_t>(state.range(0))];
    double first = 0.0, later = 0.0;
    for (auto _ : state) {
        state.PauseTiming();
        const Models models(stored->data, robot);
        state.ResumeTiming();
        first = std::max(first, longestWait(scene, robot, models, settings));
        later = std::max(later, longestWait(scene, robot, models, settings));
    }
    state.SetLabel(std::string(name(settings.method)));
    state.counters["first_ms"] = first;
    state.counters["later_ms"] = later;
}
BENCHMARK(cancelWaits)
    ->DenseRange(0, static_cast<int>(kMethods.size()) - 1)
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace terratact
