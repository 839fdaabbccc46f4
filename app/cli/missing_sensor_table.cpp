#include "app/cli/missing_sensor_table.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>

#include "app/runtime/print_text.h"
#include "core/eval/evaluation.h"
#include "core/learn/data/two_track_scene.h"
#include "core/robot/two_tracks.h"
#include "core/sim/sensor_noise.h"
#include "core/store/csv_text.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

struct MissingCase {
    std::string name;
    bool front = false, rear = false;  ///< missing currents
    std::vector<std::size_t> forces;   ///< missing force elements of both arrays
    bool rightArray = false;           ///< all elements of the right array
};

std::vector<MissingCase> missingCases()
{
    const std::vector<std::size_t> all{0, 1, 2, 3, 4, 5};
    std::vector<MissingCase> cases{{"none", false, false, {}},
                                   {"front current", true, false, {}},
                                   {"both currents", true, true, {}}};
    for (const std::size_t e : all)
        cases.push_back({fmt::format("force element {}", e + 1), false, false, {e}});
    cases.push_back({"right array", false, false, {}, true});
    cases.push_back({"all forces", false, false, all});
    cases.push_back({"currents and forces", true, true, all});
    return cases;
}

/// Leaves the forces of the left array, which has more noise than the mean of both (sidesOf()).
void keepLeftArray(Scene& scene, const RobotModel& robot, std::mt19937_64& rng)
{
    const Measurement line = measurementOf(onBothSides(scene).s);
    scene.s.force = sidesOf(line, SensorNoise{}, robot, rng).left;
}

std::vector<Scene> without(const MissingCase& lacks, std::vector<Scene> scenes,
                           const RobotModel& robot, std::uint64_t seed)
{
    std::mt19937_64 rng(seed);
    for (Scene& scene : scenes) {
        if (lacks.rightArray) keepLeftArray(scene, robot, rng);
        if (lacks.front) scene.s.frontCurrent.reset();
        if (lacks.rear) scene.s.rearCurrent.reset();
        for (const std::size_t e : lacks.forces) scene.s.force[e].reset();
    }
    return scenes;
}

/// Prints a line of the table and returns the same line for the file.
std::string judgeCase(const MissingCase& lacks, const std::vector<Scene>& scenes,
                      const EstimatorBundle& bundle, const Settings& settings, double seconds)
{
    const std::string label = labelOf(settings);
    std::vector<BinError> errors;
    std::size_t estimated = 0;
    Progress progress = sceneProgress(settings.method, scenes.size());
    forParts(scenes, [&](std::size_t first, std::span<const Scene> part) {
        Settings own = settings;
        own.seed += first;
        const auto estimates = estimateScenes(part, bundle, own, seconds, progress);
        for (std::size_t k = 0; k < part.size(); ++k) {
            if (!estimates[k].estimate) continue;
            ++estimated;
            const auto more = binErrors(first + k, part[k], label, *estimates[k].estimate);
            errors.insert(errors.end(), more.begin(), more.end());
        }
    });
    const ErrorStatistics s = statistics(errors);
    printText("{:<20}  {:<9}  {:>7}  {:>8.1f}  {:>6.1f}  {:>6.1f} %  {:>6.1f}\n", lacks.name, label,
              estimated, 1000.0 * s.median, 1000.0 * s.mean, 100.0 * s.coverage, 1000.0 * s.width);
    return csvLine({lacks.name, label, estimated, s.median, s.mean, s.coverage, s.width});
}

}  // namespace

Status printMissingSensors(const std::vector<Scene>& scenes, const EstimatorBundle& bundle,
                           const EvaluateOptions& options)
{
    printText("|error| and width of the 80 % band [mm]\n{:<20}  {:<9}  {:>7}  {:>8}  {:>6}  {:>8}  "
              "{:>6}\n",
              "not measured", "method", "scenes", "median", "mean", "covers", "width");
    std::string csv = "not_measured,method,scenes,median_m,mean_m,coverage_80,width_80_m\n";
    for (const Method method : options.methods)
        for (const MissingCase& lacks : missingCases()) {
            Settings settings = options.settings;
            settings.method = method;
            csv += judgeCase(lacks, without(lacks, scenes, bundle.robot, settings.seed), bundle,
                             settings, options.seconds);
        }
    return writeFileAtomically((std::filesystem::path(options.out) / "missing.csv").string(), csv);
}

}  // namespace terratact
