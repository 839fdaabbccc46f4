#include "app/cli/commands.h"
#include "app/modelling/trials/strip_trials.h"
#include "app/runtime/print_text.h"

namespace terratact {

Status judgeStrips(const StripOptions& options)
{
    auto grounds = drivenGrounds(options.grounds, static_cast<std::size_t>(options.drives));
    if (!grounds) return grounds.error();
    const bool isTrail = options.settings.method == Method::Trail;
    const auto bundle = openEstimatorBundle(
        options.robot, options.model, isTrail ? trailPathBeside(options.model) : std::string());
    if (!bundle) return bundle.error();
    const std::string table = stripTable(tryStrips(**bundle, {.grounds = std::move(*grounds),
                                                              .spacing = options.spacing,
                                                              .seed = options.grounds.seed,
                                                              .settings = options.settings}));
    printText("{}", Lines(table));
    return Done{};
}

}  // namespace terratact
