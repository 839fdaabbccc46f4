#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>

#include "app/commands.h"
#include "app/evaluation_figure.h"
#include "app/evaluation_report.h"
#include "app/scene_estimates.h"
#include "core/eval/claims.h"
#include "core/eval/evaluation.h"
#include "core/file_read.h"
#include "core/file_write.h"
#include "core/learn/scene_file.h"

namespace terratact {

namespace {

constexpr double kClassWidth = 0.01;  // [m] of Fig. 8's histogram
constexpr int kClasses = 15;

/// Judges one method; adds its errors and prints how it went.
void judgeMethod(Method method, const std::vector<Scene>& scenes, const Toolbox& toolbox,
                 Settings settings, std::vector<BinError>& errors)
{
    settings.method = method;
    const auto start = std::chrono::steady_clock::now();
    const auto estimates = estimateScenes(scenes, toolbox, settings);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    int converged = 0;
    int failed = 0;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        if (!estimates[k].estimate) {
            ++failed;
            continue;
        }
        converged += estimates[k].estimate->converged ? 1 : 0;
        const auto more = binErrors(k, scenes[k], *estimates[k].estimate);
        errors.insert(errors.end(), more.begin(), more.end());
    }
    fmt::print("{:<6} {} scenes, {} converged, {} without an estimate, {:.0f} ms per scene\n",
               name(method), scenes.size(), converged, failed,
               1000.0 * seconds / static_cast<double>(scenes.size()));
}

Status writeFiles(const std::filesystem::path& out, const std::vector<BinError>& errors,
                  const std::vector<Scene>& scenes, const RobotModel& robot)
{
    std::vector<std::vector<int>> underFlipper;
    underFlipper.reserve(scenes.size());
    for (const Scene& scene : scenes) underFlipper.push_back(binsUnderFrontFlipper(robot, scene.s));
    const auto fig8 = histograms(errorsInBins(errors, underFlipper), kClassWidth, kClasses);
    const auto fig9 = summarise(errors);
    for (const auto& [file, text] :
         {std::pair{"errors.csv", errorsCsv(errors, scenes)}, std::pair{"fig8.csv", fig8Csv(fig8)},
          std::pair{"fig9.csv", fig9Csv(fig9)}})
        if (Status s = writeFileAtomically((out / file).string(), text); !s) return s;
    if (!fig8.empty())
        if (Status s = writeHistogramFigure((out / "fig8.png").string(), fig8); !s) return s;
    return writeQuartileFigure((out / "fig9.png").string(), fig9);
}

bool hasTruth(const Scene& scene)
{
    return std::any_of(scene.truth.begin(), scene.truth.end(),
                       [](const auto& h) { return h.has_value(); });
}

void printClaims(const std::vector<BinError>& errors, const std::vector<Scene>& scenes,
                 const EvaluateOptions& options)
{
    const auto compared = [&](Method m) {
        return std::find(options.methods.begin(), options.methods.end(), m)
            != options.methods.end();
    };
    std::vector<ClaimResult> results;
    for (const Claim& claim : kClaims)
        if (compared(claim.base) && compared(claim.better))
            results.push_back(judge(claim, errors, scenes, options.settings.seed));
    if (!results.empty()) fmt::print("\n{}", claimsText(results));
}

}  // namespace

Status evaluate(const EvaluateOptions& options)
{
    const auto toolbox = openToolbox(options.robot, options.model);
    if (!toolbox) return toolbox.error();
    const auto file = readScenes(options.data);
    if (!file) return file.error();
    for (const std::string& notice : file->notices) fmt::print(stderr, "terratact: {}\n", notice);
    std::vector<Scene> scenes;
    std::copy_if(file->scenes.begin(), file->scenes.end(), std::back_inserter(scenes), hasTruth);
    if (scenes.empty())
        return fileError(options.data, "no scene has a known height (columns h_-0.3_m … h_+0.7_m)");
    if (scenes.size() < file->scenes.size())
        fmt::print(stderr, "terratact: {} scenes without any known height left out\n",
                   file->scenes.size() - scenes.size());
    std::error_code failed;
    std::filesystem::create_directories(options.out, failed);
    if (failed)
        return fileError(options.out, "the directory cannot be made: " + failed.message(),
                         failed.value());

    std::vector<BinError> errors;
    for (const Method method : options.methods)
        judgeMethod(method, scenes, **toolbox, options.settings, errors);
    if (errors.empty()) return fileError(options.data, "no scene has what the methods need");
    if (Status s = writeFiles(options.out, errors, scenes, (*toolbox)->robot); !s) return s;
    fmt::print("\n{}", evaluationTable(summarise(errors)));
    printClaims(errors, scenes, options);
    fmt::print("\nwritten to {}: errors.csv, fig8.csv, fig9.csv, fig8.png, fig9.png\n",
               options.out);
    return Done{};
}

}  // namespace terratact
