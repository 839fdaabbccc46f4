#include "app/figures/report/findings_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "app/figures/evaluation_figure.h"
#include "app/modelling/evaluation/evaluation_report.h"
#include "app/modelling/truth/truth_share_text.h"
#include "app/runtime/print_text.h"
#include "core/eval/claims.h"
#include "core/eval/confidence.h"
#include "core/eval/groups.h"
#include "core/store/file_group.h"

namespace terratact {
namespace {

constexpr double kClassWidth = 0.01;  // [m] class width of the histogram in Fig. 8
constexpr int kClasses = 15;
constexpr int kPitClasses = 10;

/// Statistics computed from the findings.
struct Results {
    std::vector<MethodSummary> summaries;
    std::vector<Confidence> confidences;
    std::vector<ErrorHistogram> fig8, pit;
    std::vector<GroupSummary> novelty, classes;
    std::vector<BrierSummary> steps;
    std::vector<MethodTime> times;
    std::vector<ProbeSummary> probes;
};

ProbeLimits limitsOf(const ReportOptions& options)
{
    return {.sdLimit = options.sdLimit};
}

/// Returns scenes with only drive and time, which the tables need.
std::vector<Scene> drivesOf(const Findings& findings)
{
    std::vector<Scene> scenes;
    scenes.reserve(findings.scenes.size());
    for (const EvaluatedScene& scene : findings.scenes)
        scenes.push_back({scene.run, scene.time, {}, {}});
    return scenes;
}

Classes classesOf(const Findings& findings)
{
    Classes classes;
    for (const EvaluatedScene& scene : findings.scenes) classes[scene.run] = scene.kind;
    return classes;
}

std::vector<ProbeSummary> probeSummaries(const Findings& findings)
{
    std::vector<ProbeSummary> summaries;
    summaries.reserve(findings.probes.size());
    for (const ProbeRun& run : findings.probes)
        summaries.push_back(
            summariseProbes(run.label, run.rule, run.trials, limitsOf(findings.options)));
    return summaries;
}

Results resultsOf(const Findings& findings, const std::vector<Scene>& scenes)
{
    const std::uint64_t seed = findings.options.seed;
    std::vector<std::vector<int>> underFlipper;
    underFlipper.reserve(scenes.size());
    for (const EvaluatedScene& scene : findings.scenes) underFlipper.push_back(scene.underFlipper);
    Results r;
    for (const MethodRun& run : findings.runs)
        r.times.push_back({run.label, run.seconds / static_cast<double>(run.scenes)});
    r.summaries = summarise(findings.errors);
    r.confidences = confidence(findings.errors, scenes, seed);
    r.fig8 = histograms(errorsInBins(findings.errors, underFlipper), kClassWidth, kClasses);
    r.pit = pitHistograms(findings.errors, kPitClasses);
    r.novelty = byNovelty(findings.errors);
    if (findings.options.classes) r.classes = byClass(findings.errors, scenes, classesOf(findings));
    r.steps = brierSummaries(findings.steps, scenes, seed);
    r.probes = probeSummaries(findings);
    return r;
}

Status writeTables(FileGroup& group, const std::filesystem::path& out, const Findings& findings,
                   const Results& results, const std::vector<Scene>& scenes)
{
    std::vector<std::pair<std::string, std::string>> files{
        {"errors.csv", errorsCsv(findings.errors, scenes)},
        {"fig8.csv", fig8Csv(results.fig8)},
        {"fig9.csv", fig9Csv(results.summaries)},
        {"pit.csv", pitCsv(results.pit)},
        {"coverage.csv", coverageCsv(results.summaries)},
        {"scores.csv", scoresCsv(results.summaries, results.confidences, results.times)},
        {"steps.csv", brierCsv(results.steps)},
        {"reliability.csv", reliabilityCsv(results.steps)}};
    if (!results.novelty.empty())
        files.emplace_back("novelty.csv", groupsCsv("novelty", results.novelty));
    if (!results.classes.empty())
        files.emplace_back("classes.csv", groupsCsv("class", results.classes));
    if (!results.probes.empty()) files.emplace_back("probes.csv", probesCsv(results.probes));
    for (const auto& [file, text] : files)
        if (Status s = group.add((out / file).string(), text); !s) return s;
    return Done{};
}

Status writeFigures(FileGroup& group, const std::filesystem::path& out, const Results& results)
{
    for (const std::string ending : {".png", ".svg"}) {
        const auto path = [&](const char* file) { return (out / file).string() + ending; };
        if (!results.fig8.empty())
            if (Status s = writeHistogramFigure(path("fig8"), results.fig8, group.writer()); !s)
                return s;
        if (Status s = writeQuartileFigure(path("fig9"), results.summaries, group.writer()); !s)
            return s;
        if (Status s = writePitFigure(path("pit"), results.pit, group.writer()); !s) return s;
    }
    return Done{};
}

void printTables(const Results& results, const std::vector<BinError>& errors,
                 const ReportOptions& options)
{
    printText("\n{}", Lines(evaluationTable(results.summaries)));
    printText("\n{}", Lines(scoresTable(results.summaries, results.confidences, results.times)));
    printText("\n{}", Lines(coverageTable(results.summaries)));
    if (const std::string share = truthShareText(errors); !share.empty())
        printText("\n{}", Lines(share));
    if (!results.steps.empty())
        printText("\n{}", Lines(stepsTable(results.steps, options.stepLimit)));
    if (!results.novelty.empty()) printText("\n{}", Lines(groupsTable("novelty", results.novelty)));
    if (!results.classes.empty()) printText("\n{}", Lines(groupsTable("class", results.classes)));
    if (!results.probes.empty())
        printText("\n{}", Lines(probesTable(results.probes, limitsOf(options))));
}

void printClaims(const std::vector<BinError>& errors, const std::vector<Scene>& scenes,
                 const ReportOptions& options)
{
    const auto compared = [&](Method m) {
        return std::find(options.methods.begin(), options.methods.end(), m)
            != options.methods.end();
    };
    std::vector<ClaimResult> results;
    for (const Claim& claim : kClaims)
        if (compared(claim.base) && compared(claim.better))
            results.push_back(judge(claim, errors, scenes, options.seed));
    if (!results.empty()) printText("\n{}", Lines(claimsText(results)));
}

}  // namespace

std::vector<std::string> reportFiles()
{
    return {"errors.csv", "fig8.csv",  "fig9.csv",        "pit.csv",     "coverage.csv",
            "scores.csv", "steps.csv", "reliability.csv", "novelty.csv", "classes.csv",
            "probes.csv", "fig8.png",  "fig8.svg",        "fig9.png",    "fig9.svg",
            "pit.png",    "pit.svg"};
}

void printRun(const MethodRun& run)
{
    printText("{:<10} {} scenes, {} converged, {} ended by sweeps, {} by time, {} without an "
              "estimate, {:.3g} ms per scene\n",
              run.label, run.scenes, run.converged, run.endedBySweeps, run.endedByTime, run.failed,
              1000.0 * run.seconds / static_cast<double>(run.scenes));
}

Status reportFindings(const Findings& findings, const std::string& directory)
{
    if (findings.scenes.size() != findings.total || findings.total == 0)
        throw std::invalid_argument("a report needs the findings of all scenes");
    const std::vector<Scene> scenes = drivesOf(findings);
    const Results results = resultsOf(findings, scenes);
    FileGroup group;
    if (Status s = writeTables(group, directory, findings, results, scenes); !s) return s;
    if (Status s = writeFigures(group, directory, results); !s) return s;
    if (Status s = group.commit(); !s) return s;
    printTables(results, findings.errors, findings.options);
    printClaims(findings.errors, scenes, findings.options);
    printText("\nwritten to {}: tables as CSV; fig8, fig9 and pit as PNG and SVG\n", directory);
    return Done{};
}

}  // namespace terratact
