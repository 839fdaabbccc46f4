#include "app/modelling/evaluation/scene_evaluation.h"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "app/modelling/trials/probe_trials.h"
#include "app/runtime/parallel.h"
#include "app/runtime/stopwatch.h"
#include "core/eval/baselines.h"
#include "core/eval/evaluation.h"
#include "core/eval/step_forecasts.h"
#include "core/learn/model/surface_rows.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"

namespace terratact {

namespace {

/// The scenes of one part (shard).
struct Workload {
    std::vector<Scene> scenes;
    std::size_t first = 0;  ///< number of the part's first scene among all
    const EstimatorBundle& bundle;
    const EvaluateOptions& options;
    const std::function<void(const MethodRun&)>& ended;
};

/// Returns the errors of one estimate; -0 becomes 0, because files do not keep it.
std::vector<BinError> keptErrors(std::size_t number, const Scene& scene, const std::string& label,
                                 const TerrainEstimate& estimate)
{
    std::vector<BinError> errors = binErrors(number, scene, label, estimate);
    for (BinError& e : errors) {
        e.error += 0.0;
        e.scores.crps += 0.0;
        e.scores.width += 0.0;
    }
    return errors;
}

template <class Entry>
void append(std::vector<Entry>& into, const std::vector<Entry>& more)
{
    into.insert(into.end(), more.begin(), more.end());
}

/// Adds the errors and forecasts of a part to a method's or baseline's run. first: number of the part's first scene
/// among all.
void judgeEstimates(MethodRun& run, std::size_t first, std::span<const Scene> scenes,
                    const std::vector<SceneEstimate>& estimates, double stepLimit,
                    Findings& findings)
{
    run.scenes += scenes.size();
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const auto& estimate = estimates[k].estimate;
        if (!estimate) {
            ++run.failed;
            continue;
        }
        run.converged += estimate->converged ? 1 : 0;
        run.endedBySweeps += estimate->ending == Ending::Sweeps ? 1 : 0;
        run.endedByTime += estimate->ending == Ending::Time ? 1 : 0;
        append(findings.errors, keptErrors(first + k, scenes[k], run.label, *estimate));
        append(findings.steps,
               stepForecasts(first + k, scenes[k], run.label, *estimate, stepLimit));
    }
}

/// Adds the trials of a part to those of each rule.
void addTrials(std::vector<ProbeRun>& all, std::vector<ProbeRun> part)
{
    if (all.empty()) {
        all = std::move(part);
        return;
    }
    for (std::size_t rule = 0; rule < all.size(); ++rule)
        append(all[rule].trials, part.at(rule).trials);
}

void judgeMethod(Method method, const Workload& work, Findings& findings)
{
    Settings settings = work.options.settings;
    settings.method = method;
    const EvaluateOptions& options = work.options;
    MethodRun run{.label = labelOf(settings)};
    run.contradicting = 0;
    std::vector<ProbeRun> probes;
    Progress progress = sceneProgress(method, work.scenes.size());
    forParts(work.scenes, [&](std::size_t begin, std::span<const Scene> scenes) {
        const std::size_t first = work.first + begin;
        Settings ofFirst = settings;
        ofFirst.seed += first;
        const Stopwatch watch;
        auto estimates = estimateScenes(scenes, work.bundle, ofFirst, options.seconds, progress);
        run.seconds += watch.seconds();
        if (options.probes && !usesArm(method))
            addTrials(probes, tryProbeRules(run.label, scenes, estimates, first, work.bundle,
                                            settings, options.stepLimit, options.seconds));
        *run.contradicting += checkEstimates(scenes, work.bundle.robot, estimates);
        judgeEstimates(run, first, scenes, estimates, options.stepLimit, findings);
    });
    append(findings.probes, probes);
    work.ended(run);
    findings.runs.push_back(std::move(run));
}

SceneEstimate estimateBaseline(const Baseline& baseline, const RobotModel& robot,
                               const Scene& scene, std::uint64_t seed)
{
    if (const std::string_view missing = missingFeature(baseline.needs(), scene.s);
        !missing.empty())
        return {std::nullopt, fmt::format("{} is unknown", missing)};
    return {baselineEstimate(baseline, robot, scene.s, seed), {}};
}

void judgeBaselines(const Workload& work, Findings& findings)
{
    const EstimatorBundle& bundle = work.bundle;
    const auto sideBySide = [](int count, const std::function<void(int)>& each) {
        parallelFor(count, each);
    };
    for (const auto& baseline : fitBaselines(bundle.robot, bundle.model.data, sideBySide)) {
        MethodRun run{.label = std::string(baseline->name())};
        forParts(work.scenes, [&](std::size_t begin, std::span<const Scene> scenes) {
            const std::size_t first = work.first + begin;
            std::vector<SceneEstimate> estimates(scenes.size());
            const Stopwatch watch;
            parallelFor(static_cast<int>(scenes.size()), [&](int n) {
                const auto k = static_cast<std::size_t>(n);
                estimates[k] = estimateBaseline(*baseline, bundle.robot, scenes[k],
                                                work.options.settings.seed + first + k);
            });
            run.seconds += watch.seconds();
            judgeEstimates(run, first, scenes, estimates, work.options.stepLimit, findings);
        });
        work.ended(run);
        findings.runs.push_back(std::move(run));
    }
}

/// Reads the index file of the classes, if one is given.
Result<std::optional<Classes>> classesOf(const EvaluateOptions& options)
{
    if (options.classes.empty()) return std::optional<Classes>();
    auto read = readClasses(options.classes, options.classColumn);
    if (!read) return read.error();
    return std::optional(*std::move(read));
}

std::vector<EvaluatedScene> evaluatedScenes(const Workload& work,
                                            const std::optional<Classes>& classes)
{
    std::vector<EvaluatedScene> scenes;
    for (const Scene& scene : work.scenes) {
        EvaluatedScene known{scene.run, scene.time + 0.0,
                             binsUnderFrontFlipper(work.bundle.robot, scene.s), ""};
        if (classes) {
            const auto found = classes->find(scene.run);
            known.kind = found == classes->end() ? std::string(kNoClass) : found->second;
        }
        scenes.push_back(std::move(known));
    }
    return scenes;
}

Result<std::string> hashOfFile(const std::string& path)
{
    return path.empty() ? std::string("(none)") : sha256OfFile(path);
}

/// Returns the values that must agree between parts of one evaluation.
Result<std::map<std::string, std::string>>
originOf(const EvaluateOptions& options, const std::string& modelHash, const std::string& dataHash)
{
    std::map<std::string, std::string> origin{{"version", TERRATACT_VERSION},
                                              {"command", options.command},
                                              {"model's content", modelHash},
                                              {"scenes' SHA-256", dataHash}};
    for (const auto& [what, path] : {std::pair("robot's SHA-256", &options.robot),
                                     std::pair("classes' SHA-256", &options.classes)}) {
        auto hash = hashOfFile(*path);
        if (!hash) return hash.error();
        origin[what] = *std::move(hash);
    }
    return origin;
}

Status judgeAll(const Workload& work, Findings& findings)
{
    for (const Method method : work.options.methods) judgeMethod(method, work, findings);
    if (!work.options.shard && findings.errors.empty())
        return fileError(work.options.data, "no scene has what the methods need");
    judgeBaselines(work, findings);
    return Done{};
}

/// Returns the scenes of the requested part.
Result<std::vector<Scene>> scenesOf(const Shard& shard, std::vector<Scene> all,
                                    const std::string& path)
{
    if (static_cast<std::size_t>(shard.count) > all.size())
        return fileError(path, fmt::format("has {} scenes, expected at least {} for as many parts",
                                           all.size(), shard.count));
    const auto at = [&all](std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k); };
    return std::vector<Scene>(at(shard.begin(all.size())), at(shard.end(all.size())));
}

}  // namespace

Result<EvaluationInput> readEvaluationInput(const EvaluateOptions& options)
{
    auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    auto classes = classesOf(options);
    if (!classes) return classes.error();
    auto file = readScenesWithTruth(options.data);
    if (!file) return file.error();
    const std::size_t trained = trainingScenes(file->scenes, (*bundle)->model.data);
    return EvaluationInput{*std::move(bundle), *std::move(classes), *std::move(file), trained};
}

Result<Findings> evaluateScenes(const EvaluationInput& input, const EvaluateOptions& options,
                                const std::function<void(const MethodRun&)>& ended)
{
    const EstimatorBundle& bundle = *input.bundle;
    Findings findings{.origin = {},
                      .options = {options.methods, options.settings.seed, options.stepLimit,
                                  options.settings.probeAbove, input.classes.has_value()},
                      .shard = options.shard.value_or(Shard{}),
                      .total = input.file.scenes.size(),
                      .scenes = {},
                      .runs = {},
                      .errors = {},
                      .steps = {},
                      .probes = {}};
    auto scenes = scenesOf(findings.shard, input.file.scenes, options.data);
    if (!scenes) return scenes.error();
    const Workload work{*std::move(scenes), findings.shard.begin(findings.total), bundle, options,
                        ended};
    findings.scenes = evaluatedScenes(work, input.classes);
    if (Status s = judgeAll(work, findings); !s) return s.error();
    if (!options.shard) return findings;
    auto origin = originOf(options, bundle.model.contentHash, input.file.hash);
    if (!origin) return origin.error();
    findings.origin = *std::move(origin);
    return findings;
}

std::vector<CardScores> cardScores(const Findings& findings, std::size_t trained)
{
    std::vector<CardScores> scores;
    for (std::size_t k = 0; k < findings.options.methods.size(); ++k) {
        const MethodRun& run = findings.runs[k];
        if (run.failed == run.scenes) continue;
        const ErrorStatistics all = statistics(errorsOf(run.label, findings.errors));
        scores.push_back({.method = run.label,
                          .date = {},
                          .data = {},
                          .dataHash = {},
                          .scenes = run.scenes - run.failed,
                          .trainingScenes = trained,
                          .meanError = all.mean,
                          .coverage = all.coverage});
    }
    return scores;
}

}  // namespace terratact
