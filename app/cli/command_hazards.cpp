#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/modelling/evaluation/two_track_evaluation.h"
#include "app/modelling/trials/hazard_trials.h"
#include "app/modelling/trials/manoeuvre_hazards.h"
#include "app/modelling/trials/track_hazards.h"
#include "app/runtime/print_text.h"
#include "app/runtime/resources.h"

namespace terratact {

namespace {

/// Prints two tables. In the first, Trail and Local estimate the same drives. In the second, drives turn, reverse and
/// probe.
void printRemembered(const EstimatorBundle& bundle, HazardTrial trial, bool manoeuvresOnly)
{
    const std::string manoeuvres = manoeuvreTable(tryManoeuvres(bundle, trial));
    printText("{}", Lines(manoeuvres));
    if (manoeuvresOnly) return;
    printText("\n");
    trial.remembers = true;
    for (const Method method : {Method::Trail, Method::Local}) {
        trial.settings.method = method;
        const std::string table = trackHazardTable(tryTrackHazards(bundle, trial));
        printText("by {}\n{}\n", name(method), Lines(table));
    }
}

}  // namespace

Status judgeHazards(const HazardsOptions& options)
{
    const auto bundle =
        openEstimatorBundle(options.robot, options.model,
                            options.memory ? trailPathBeside(options.model) : std::string());
    if (!bundle) return bundle.error();
    HazardTrial trial;
    trial.drives = options.drives;
    trial.seed = options.settings.seed;
    trial.stepLimit = options.stepLimit;
    trial.settings = options.settings;
    if (!options.rates.empty()) trial.rates = options.rates;
    if (options.tracks) {
        if (!isClosedForm(trial.settings.method))
            return Error{
                fmt::format(
                    "hazards --tracks: method {} estimates one plane, expected local or joint",
                    name(trial.settings.method)),
                0};
        if (!(*bundle)->models.sides) return modelOfOnePlane(options.model);
        if (options.memory) {
            printRemembered(**bundle, trial, options.manoeuvres);
            return Done{};
        }
        const std::string sides = trackHazardTable(tryTrackHazards(**bundle, trial));
        printText("{}", Lines(sides));
        return Done{};
    }
    const auto lines = tryHazards(**bundle, trial);
    const std::string table = hazardTable(lines, trial.rates.back());
    printText("{}", Lines(table));
    return Done{};
}

}  // namespace terratact
