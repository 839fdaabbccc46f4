#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <span>

#include "app/cli/commands.h"
#include "app/modelling/estimate_csv.h"
#include "app/modelling/evaluation/two_track_csv.h"
#include "app/modelling/evaluation/two_track_evaluation.h"
#include "app/modelling/scene_estimates.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/store/file_read.h"

namespace terratact {

namespace {

void printContradictions(const std::string& out, std::size_t count)
{
    if (count == 0) return;
    printText(messagesBeside(out),
              "{} estimates contradict their readings: their verdict is withheld\n", count);
}

Status reconstructTracks(const ReconstructOptions& options, const EstimatorBundle& bundle)
{
    if (!bundle.model.data.hasSides()) return modelOfOnePlane(options.model);
    if (!isClosedForm(options.settings.method))
        return fileError(options.data, "two tracks are estimated by --method local or joint");
    const auto file = readTwoTrackScenes(options.data);
    if (!file) return file.error();
    for (const Message& notice : file->notices)
        printText(stderr, "terratact: {}\n", notice.english());
    std::string csv = twoTrackCsvHeader();
    std::size_t contradicting = 0;
    std::ptrdiff_t none = 0, planes = 0;
    forParts(file->scenes, [&](std::size_t first, std::span<const TwoTrackScene> scenes) {
        Settings own = options.settings;
        own.seed += first;
        TrackEstimates estimates = estimateTracks(TrackApproach::Both, scenes, bundle, own);
        contradicting += checkTracks(scenes, bundle.robot, estimates);
        csv += twoTrackCsvRows(scenes, bundle.robot, estimates);
        none += std::ranges::count_if(estimates, [](const auto& e) { return !e; });
        planes += std::ranges::count_if(estimates, [](const auto& e) { return e && e->onePlane; });
    });
    if (Status written = writeText(options.out, csv); !written) return written;
    printText(
        messagesBeside(options.out),
        "{} scenes of two tracks written to {}; {} not estimated, {} estimated as one plane\n",
        file->scenes.size(), options.out, none, planes);
    printContradictions(options.out, contradicting);
    return Done{};
}

}  // namespace

Status reconstructScenes(const ReconstructOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    if (options.tracks) return reconstructTracks(options, **bundle);
    const auto file = readScenes(options.data);
    if (!file) return file.error();
    for (const Message& notice : file->notices)
        printText(stderr, "terratact: {}\n", notice.english());

    std::string csv = estimateCsvHeader();
    std::size_t contradicting = 0;
    std::ptrdiff_t noted = 0;
    Progress progress = sceneProgress(options.settings.method, file->scenes.size());
    forParts(file->scenes, [&](std::size_t first, std::span<const Scene> scenes) {
        Settings own = options.settings;
        own.seed += first;
        auto estimates = estimateScenes(scenes, **bundle, own, options.seconds, progress);
        contradicting += checkEstimates(scenes, (*bundle)->robot, estimates);
        csv += estimateCsvRows(scenes, estimates);
        noted += std::ranges::count_if(estimates, [](const auto& e) { return !e.note.empty(); });
    });
    if (Status written = writeText(options.out, csv); !written) return written;
    printText(messagesBeside(options.out), "{} scenes written to {}; {} of them with a note\n",
              file->scenes.size(), options.out, noted);
    printContradictions(options.out, contradicting);
    return Done{};
}

}  // namespace terratact
