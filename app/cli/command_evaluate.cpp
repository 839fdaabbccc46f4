#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/missing_sensor_table.h"
#include "app/figures/findings_report.h"
#include "app/modelling/findings_file.h"
#include "app/modelling/model_cards.h"
#include "app/modelling/scene_evaluation.h"
#include "app/modelling/two_track_evaluation.h"
#include "app/runtime/print_text.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/store/file_write.h"

namespace terratact {

namespace {

void printNotices(const EvaluationInput& input)
{
    for (const Message& notice : input.file.notices)
        printText(stderr, "terratact: {}\n", notice.english());
    if (input.trained > 0)
        printText(stderr,
                  "terratact: {} of {} scenes are training scenes of this model: errors look "
                  "smaller than they are\n",
                  input.trained, input.file.scenes.size());
}

void printRunAndContradictions(const MethodRun& run)
{
    printRun(run);
    if (run.contradicting)
        printText(stderr, "terratact: {}: {} of {} estimates contradict their readings\n",
                  run.label, *run.contradicting, run.scenes - run.failed);
}

Status writePart(const EvaluateOptions& options, const Findings& findings)
{
    const std::string path =
        (std::filesystem::path(options.out) / shardFile(findings.shard)).string();
    if (Status s = writeFindings(path, findings); !s) return s;
    printText("\n{} of {} scenes; written to {}, for `terratact merge`\n", findings.scenes.size(),
              findings.total, path);
    return Done{};
}

std::string inFolder(const EvaluateOptions& options, const char* name)
{
    return (std::filesystem::path(options.out) / name).string();
}

Status reportTracks(const TrackFindings& findings, const EvaluateOptions& options)
{
    printText("{}", Lines(tracksTable(findings)));
    if (Status s = writeFileAtomically(inFolder(options, "tracks.csv"), tracksCsv(findings)); !s)
        return s;
    return writeFileAtomically(inFolder(options, "track_steps.csv"), trackStepsCsv(findings));
}

Status reportMissing(const std::vector<TrackMissing>& missing, const EvaluateOptions& options)
{
    printText("{}", Lines(missingTable(missing)));
    return writeFileAtomically(inFolder(options, "missing.csv"), missingCsv(missing));
}

Status evaluateTwoTracks(const EvaluateOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    if (!(*bundle)->model.data.hasSides()) return modelOfOnePlane(options.model);
    EvaluateOptions own = options;
    std::erase_if(own.methods, [](Method method) { return !isClosedForm(method); });
    if (own.methods.empty())
        return fileError(options.data, "two tracks are estimated by local or joint: expected one "
                                       "of them in --methods");
    const bool local = std::ranges::find(own.methods, Method::Local) != own.methods.end();
    own.methods = {local ? Method::Local : Method::Joint};
    const auto file = readTwoTrackScenes(options.data);
    if (!file) return file.error();
    for (const Message& notice : file->notices)
        printText(stderr, "terratact: {}\n", notice.english());
    if (Status s = makeDirectory(options.out); !s) return s;
    printText("method {}\n", name(own.methods.front()));
    if (options.missing) return reportMissing(evaluateMissing(file->scenes, **bundle, own), own);
    return reportTracks(evaluateTracks(file->scenes, **bundle, own), own);
}

}  // namespace

Status evaluate(const EvaluateOptions& options)
{
    if (options.tracks) return evaluateTwoTracks(options);
    const auto input = readEvaluationInput(options);
    if (!input) return input.error();
    printNotices(*input);
    if (Status s = makeDirectory(options.out); !s) return s;
    if (options.missing) return printMissingSensors(input->file.scenes, *input->bundle, options);
    const auto findings = evaluateScenes(*input, options, printRunAndContradictions);
    if (!findings) return findings.error();
    if (options.shard) return writePart(options, *findings);
    if (Status s = reportFindings(*findings, options.out); !s || !options.card) return s;
    return keepScores(options.model, input->bundle->model.contentHash, options.data,
                      input->file.hash, cardScores(*findings, input->trained));
}

}  // namespace terratact
