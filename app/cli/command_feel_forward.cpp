#include "app/cli/commands.h"
#include "app/modelling/trials/feel_forward_trials.h"
#include "app/runtime/print_text.h"
#include "app/runtime/resources.h"

namespace terratact {

Status tryFeelForward(const FeelForwardOptions& options)
{
    const bool isTrail = options.settings.method == Method::Trail;
    const auto bundle = openEstimatorBundle(
        options.robot, options.model, isTrail ? trailPathBeside(options.model) : std::string());
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
