#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/missing_sensor_table.h"
#include "app/figures/report/findings_report.h"
#include "app/modelling/evaluation/model_cards.h"
#include "app/modelling/evaluation/scene_evaluation.h"
#include "app/modelling/evaluation/two_track_evaluation.h"
#include "app/modelling/findings_file.h"
#include "app/modelling/trials/drive_trials.h"
#include "app/runtime/print_text.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/learn/model/surface_rows.h"
#include "core/store/file_group.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sha256.h"
#include "core/trail/trail_model.h"

namespace terratact {

namespace {

/// trained: number of the scenes that the model was trained on, and near copies of them.
void printTrained(std::size_t trained, std::size_t scenes)
{
    if (trained > 0)
        printText(stderr,
                  "terratact: {} of {} scenes are training scenes of this model or near copies of "
                  "them: errors look smaller than they are\n",
                  trained, scenes);
}

void printNotices(const std::vector<Message>& notices, std::size_t trained, std::size_t scenes)
{
    for (const Message& notice : notices) printText(stderr, "terratact: {}\n", notice.english());
    printTrained(trained, scenes);
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

Status reportTracks(const std::vector<TwoTrackScene>& scenes, const EstimatorBundle& bundle,
                    const EvaluateOptions& options)
{
    std::vector<TrackFindings> methods;
    for (const Method method : options.methods) {
        methods.push_back(evaluateTracks(scenes, bundle, options, method));
        const std::string gap = methods.size() > 1 ? "\n" : "";
        printText("{}", Lines(gap + tracksTable(methods.back())));
    }
    FileGroup files;
    if (Status s = files.add(inFolder(options, "tracks.csv"), tracksCsv(methods)); !s) return s;
    if (Status s = files.add(inFolder(options, "track_steps.csv"), trackStepsCsv(methods)); !s)
        return s;
    return files.commit();
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
    if (options.missing && !isClosedForm(options.methods.front()))
        return fileError(options.data, "the errors without some sensors are those of local or "
                                       "joint: expected one of them first in --methods");
    const auto file = readTwoTrackScenes(options.data);
    if (!file) return file.error();
    printNotices(file->notices, trainingScenes(file->scenes, (*bundle)->model.data.sides),
                 file->scenes.size());
    if (Status s = makeDirectory(options.out); !s) return s;
    if (options.missing)
        return reportMissing(evaluateMissing(file->scenes, **bundle, options), options);
    return reportTracks(file->scenes, **bundle, options);
}

/// Returns true if the networks do not know their drives, but have learnt from exactly this file.
bool haveLearntFile(const TrailData& networks, const std::string& drives)
{
    if (!networks.plane.drives.empty() || !networks.side.drives.empty()) return false;
    std::error_code none;
    if (!std::filesystem::is_regular_file(drives, none)) return false;  // a pipe is read only once
    const auto hash = sha256OfFile(drives);
    return hash && (*hash == networks.planeHash || *hash == networks.sideHash);
}

/// Warns if the model was trained on some of these scenes, or the networks on some of these drives.
void printTrained(const DriveFindings& findings, const Models& models, const std::string& drives)
{
    printTrained(findings.trainingScenes, findings.scenes + findings.early);
    if (findings.trainingDrives > 0)
        printText(stderr,
                  "terratact: the networks have learnt from {} of {} drives: errors of trail look "
                  "smaller than they are\n",
                  findings.trainingDrives, findings.drives);
    else if (models.trail && haveLearntFile(models.trail->data(), drives))
        printText(stderr, "terratact: the networks have learnt from these drives: errors of trail "
                          "look smaller than they are\n");
}

Status evaluateDrives(const EvaluateOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model, options.trail);
    if (!bundle) return bundle.error();
    const auto findings = judgeDriveFile(
        options.drives, **bundle, options.methods, options.settings,
        [](const Message& notice) { printText(stderr, "terratact: {}\n", notice.english()); });
    if (!findings) return findings.error();
    printTrained(*findings, (*bundle)->models, options.drives);
    printText("{}", Lines(driveTable(*findings)));
    return Done{};
}

}  // namespace

Status evaluate(const EvaluateOptions& options)
{
    if (!options.drives.empty()) return evaluateDrives(options);
    if (options.tracks) return evaluateTwoTracks(options);
    const auto input = readEvaluationInput(options);
    if (!input) return input.error();
    printNotices(input->file.notices, input->trained, input->file.scenes.size());
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
