#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "app/commands.h"
#include "app/evaluation_figure.h"
#include "app/evaluation_report.h"
#include "app/parallel.h"
#include "app/probe_trials.h"
#include "app/scene_estimates.h"
#include "core/eval/baselines.h"
#include "core/eval/claims.h"
#include "core/eval/confidence.h"
#include "core/eval/evaluation.h"
#include "core/eval/groups.h"
#include "core/eval/step_forecasts.h"
#include "core/file_read.h"
#include "core/file_write.h"
#include "core/learn/scene_file.h"

namespace terratact {

namespace {

constexpr double kClassWidth = 0.01;  // [m] of Fig. 8's histogram
constexpr int kClasses = 15;
constexpr int kPitClasses = 10;

/// What has been found out so far.
struct Findings {
    std::vector<BinError> errors;
    std::vector<StepForecast> steps;
    std::vector<MethodTime> times;
    std::vector<ProbeSummary> probes;
};

class Stopwatch {
public:
    double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Adds the errors and forecasts of one method or baseline and prints how it went.
void judgeEstimates(const std::string& label, const std::vector<Scene>& scenes,
                    const std::vector<SceneEstimate>& estimates, double seconds, double stepLimit,
                    Findings& findings)
{
    int converged = 0;
    int failed = 0;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const auto& estimate = estimates[k].estimate;
        if (!estimate) {
            ++failed;
            continue;
        }
        converged += estimate->converged ? 1 : 0;
        const auto errors = binErrors(k, scenes[k], label, *estimate);
        findings.errors.insert(findings.errors.end(), errors.begin(), errors.end());
        const auto steps = stepForecasts(k, scenes[k], label, *estimate, stepLimit);
        findings.steps.insert(findings.steps.end(), steps.begin(), steps.end());
    }
    const double perScene = seconds / static_cast<double>(scenes.size());
    findings.times.push_back({label, perScene});
    fmt::print("{:<10} {} scenes, {} converged, {} without an estimate, {:.3g} ms per scene\n",
               label, scenes.size(), converged, failed, 1000.0 * perScene);
}

void judgeMethod(Method method, const std::vector<Scene>& scenes, const Toolbox& toolbox,
                 const EvaluateOptions& options, Findings& findings)
{
    Settings settings = options.settings;
    settings.method = method;
    const std::string label = labelOf(settings);
    const Stopwatch watch;
    const auto estimates = estimateScenes(scenes, toolbox, settings);
    judgeEstimates(label, scenes, estimates, watch.seconds(), options.stepLimit, findings);
    if (!options.probes || usesArm(method)) return;
    const auto probes =
        tryProbeRules(label, scenes, estimates, toolbox, settings, options.stepLimit);
    findings.probes.insert(findings.probes.end(), probes.begin(), probes.end());
}

SceneEstimate estimateBaseline(const Baseline& baseline, const RobotModel& robot,
                               const Scene& scene, std::uint64_t seed)
{
    if (const std::string_view missing = missingFeature(baseline.needs(), scene.s);
        !missing.empty())
        return {std::nullopt, fmt::format("{} is unknown", missing)};
    return {baselineEstimate(baseline, robot, scene.s, seed), {}};
}

void judgeBaselines(const std::vector<Scene>& scenes, const Toolbox& toolbox,
                    const EvaluateOptions& options, Findings& findings)
{
    const auto sideBySide = [](int count, const std::function<void(int)>& work) {
        parallelFor(count, work);
    };
    for (const auto& baseline : fitBaselines(toolbox.robot, toolbox.model.data, sideBySide)) {
        std::vector<SceneEstimate> estimates(scenes.size());
        const Stopwatch watch;
        parallelFor(static_cast<int>(scenes.size()), [&](int n) {
            const auto k = static_cast<std::size_t>(n);
            estimates[k] =
                estimateBaseline(*baseline, toolbox.robot, scenes[k], options.settings.seed + k);
        });
        judgeEstimates(std::string(baseline->name()), scenes, estimates, watch.seconds(),
                       options.stepLimit, findings);
    }
}

/// What the findings come to.
struct Results {
    std::vector<MethodSummary> summaries;
    std::vector<Confidence> confidences;
    std::vector<ErrorHistogram> fig8, pit;
    std::vector<GroupSummary> novelty, classes;
    std::vector<BrierSummary> steps;
};

Results resultsOf(const Findings& findings, const std::vector<Scene>& scenes,
                  const RobotModel& robot, const std::optional<Classes>& classes,
                  const EvaluateOptions& options)
{
    std::vector<std::vector<int>> underFlipper;
    underFlipper.reserve(scenes.size());
    for (const Scene& scene : scenes) underFlipper.push_back(binsUnderFrontFlipper(robot, scene.s));
    Results r;
    r.summaries = summarise(findings.errors);
    r.confidences = confidence(findings.errors, scenes, options.settings.seed);
    r.fig8 = histograms(errorsInBins(findings.errors, underFlipper), kClassWidth, kClasses);
    r.pit = pitHistograms(findings.errors, kPitClasses);
    r.novelty = byNovelty(findings.errors);
    if (classes) r.classes = byClass(findings.errors, scenes, *classes);
    r.steps = brierSummaries(findings.steps, scenes, options.settings.seed);
    return r;
}

Status writeTables(const std::filesystem::path& out, const Findings& findings,
                   const Results& results, const std::vector<Scene>& scenes)
{
    std::vector<std::pair<std::string, std::string>> files{
        {"errors.csv", errorsCsv(findings.errors, scenes)},
        {"fig8.csv", fig8Csv(results.fig8)},
        {"fig9.csv", fig9Csv(results.summaries)},
        {"pit.csv", pitCsv(results.pit)},
        {"coverage.csv", coverageCsv(results.summaries)},
        {"scores.csv", scoresCsv(results.summaries, results.confidences, findings.times)},
        {"steps.csv", brierCsv(results.steps)},
        {"reliability.csv", reliabilityCsv(results.steps)}};
    if (!results.novelty.empty())
        files.emplace_back("novelty.csv", groupsCsv("novelty", results.novelty));
    if (!results.classes.empty())
        files.emplace_back("classes.csv", groupsCsv("class", results.classes));
    if (!findings.probes.empty()) files.emplace_back("probes.csv", probesCsv(findings.probes));
    for (const auto& [file, text] : files)
        if (Status s = writeFileAtomically((out / file).string(), text); !s) return s;
    return Done{};
}

Status writeFigures(const std::filesystem::path& out, const Results& results)
{
    for (const std::string ending : {".png", ".svg"}) {
        const auto path = [&](const char* file) { return (out / file).string() + ending; };
        if (!results.fig8.empty())
            if (Status s = writeHistogramFigure(path("fig8"), results.fig8); !s) return s;
        if (Status s = writeQuartileFigure(path("fig9"), results.summaries); !s) return s;
        if (Status s = writePitFigure(path("pit"), results.pit); !s) return s;
    }
    return Done{};
}

void printTables(const Findings& findings, const Results& results, const EvaluateOptions& options)
{
    fmt::print("\n{}", evaluationTable(results.summaries));
    fmt::print("\n{}", scoresTable(results.summaries, results.confidences, findings.times));
    fmt::print("\n{}", coverageTable(results.summaries));
    if (!results.steps.empty()) fmt::print("\n{}", stepsTable(results.steps, options.stepLimit));
    if (!results.novelty.empty()) fmt::print("\n{}", groupsTable("novelty", results.novelty));
    if (!results.classes.empty()) fmt::print("\n{}", groupsTable("class", results.classes));
    if (!findings.probes.empty())
        fmt::print("\n{}", probesTable(findings.probes, {.sdLimit = options.settings.probeAbove}));
}

bool hasTruth(const Scene& scene)
{
    return std::any_of(scene.truth.begin(), scene.truth.end(),
                       [](const auto& h) { return h.has_value(); });
}

Result<std::vector<Scene>> scenesWithTruth(const std::string& path)
{
    const auto file = readScenes(path);
    if (!file) return file.error();
    for (const std::string& notice : file->notices) fmt::print(stderr, "terratact: {}\n", notice);
    std::vector<Scene> scenes;
    std::copy_if(file->scenes.begin(), file->scenes.end(), std::back_inserter(scenes), hasTruth);
    if (scenes.empty())
        return fileError(path, "no scene has a known height (columns h_-0.3_m … h_+0.7_m)");
    if (scenes.size() < file->scenes.size())
        fmt::print(stderr, "terratact: {} scenes without any known height left out\n",
                   file->scenes.size() - scenes.size());
    return scenes;
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
    std::optional<Classes> classes;
    if (!options.classes.empty()) {
        auto read = readClasses(options.classes, options.classColumn);
        if (!read) return read.error();
        classes = *std::move(read);
    }
    const auto scenes = scenesWithTruth(options.data);
    if (!scenes) return scenes.error();
    std::error_code failed;
    std::filesystem::create_directories(options.out, failed);
    if (failed)
        return fileError(options.out, "the directory cannot be made: " + failed.message(),
                         failed.value());

    Findings findings;
    for (const Method method : options.methods)
        judgeMethod(method, *scenes, **toolbox, options, findings);
    if (findings.errors.empty())
        return fileError(options.data, "no scene has what the methods need");
    judgeBaselines(*scenes, **toolbox, options, findings);
    const Results results = resultsOf(findings, *scenes, (*toolbox)->robot, classes, options);
    if (Status s = writeTables(options.out, findings, results, *scenes); !s) return s;
    if (Status s = writeFigures(options.out, results); !s) return s;
    printTables(findings, results, options);
    printClaims(findings.errors, *scenes, options);
    fmt::print("\nwritten to {}: tables as CSV; fig8, fig9 and pit as PNG and SVG\n", options.out);
    return Done{};
}

}  // namespace terratact
