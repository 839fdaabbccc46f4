#include <fmt/core.h>

#include <algorithm>

#include "app/cli/commands.h"
#include "app/modelling/estimate_csv.h"
#include "app/modelling/scene_estimates.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/learn/data/scene_file.h"

namespace terratact {

Status reconstructScenes(const ReconstructOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
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
    if (contradicting > 0)
        printText(messagesBeside(options.out),
                  "{} estimates contradict their readings: their verdict is withheld\n",
                  contradicting);
    return Done{};
}

}  // namespace terratact
