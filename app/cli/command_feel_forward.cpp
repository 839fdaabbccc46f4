#include "app/cli/commands.h"
#include "app/modelling/feel_forward_trials.h"
#include "app/runtime/print_text.h"

namespace terratact {

Status tryFeelForward(const FeelForwardOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    const FeelForwardTrial trial{.drives = options.drives,
                                 .seed = options.settings.seed,
                                 .stepLimit = options.stepLimit,
                                 .settings = options.settings,
                                 .estimateSeconds = options.estimateSeconds,
                                 .isBlind = options.isBlind};
    const auto lines = tryFeelForward(**bundle, trial);
    const std::string table = feelForwardTable(lines, (*bundle)->robot, trial);
    printText("{}", Lines(table));
    return Done{};
}

}  // namespace terratact
