#include "app/cli/commands.h"
#include "app/modelling/hazard_trials.h"
#include "app/runtime/print_text.h"

namespace terratact {

Status judgeHazards(const HazardsOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    HazardTrial trial;
    trial.drives = options.drives;
    trial.seed = options.settings.seed;
    trial.stepLimit = options.stepLimit;
    trial.settings = options.settings;
    if (!options.rates.empty()) trial.rates = options.rates;
    const auto lines = tryHazards(**bundle, trial);
    const std::string table = hazardTable(lines, trial.rates.back());
    printText("{}", Lines(table));
    return Done{};
}

}  // namespace terratact
