#include <fmt/core.h>

#include <algorithm>

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

void tellContradictions(const std::string& out, std::size_t count)
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
    TrackEstimates estimates =
        estimateTracks(TrackApproach::Both, file->scenes, bundle, options.settings);
    const std::size_t contradicting = checkTracks(file->scenes, bundle.robot, estimates);
    if (Status written = writeText(options.out, twoTrackCsv(file->scenes, bundle.robot, estimates));
        !written)
        return written;
    const auto made = std::ranges::count_if(estimates, [](const auto& e) { return e.has_value(); });
    const auto planes = std::ranges::count_if(
        estimates, [](const auto& e) { return e.has_value() && e->onePlane; });
    printText(
        messagesBeside(options.out),
        "{} scenes of two tracks written to {}; {} not estimated, {} estimated as one plane\n",
        estimates.size(), options.out, std::ssize(estimates) - made, planes);
    tellContradictions(options.out, contradicting);
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

    auto estimates = estimateScenes(file->scenes, **bundle, options.settings, options.seconds);
    const std::size_t contradicting = checkEstimates(file->scenes, (*bundle)->robot, estimates);
    const std::string csv = estimateCsv(file->scenes, estimates);
    if (Status written = writeText(options.out, csv); !written) return written;
    const auto noted = std::count_if(estimates.begin(), estimates.end(),
                                     [](const auto& e) { return !e.note.empty(); });
    printText(messagesBeside(options.out), "{} scenes written to {}; {} of them with a note\n",
              estimates.size(), options.out, noted);
    tellContradictions(options.out, contradicting);
    return Done{};
}

}  // namespace terratact
