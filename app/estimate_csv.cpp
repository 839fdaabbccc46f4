#include "app/estimate_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

namespace terratact {

namespace {

std::string shown(std::optional<double> value)
{
    return value ? fmt::format("{}", *value) : std::string();
}

/// A text field of our CSV files holds neither commas nor quotes.
std::string field(std::string text)
{
    for (char& c : text)
        if (c == ',' || c == '"') c = ';';
    return text;
}

void addRows(std::string& csv, const Scene& scene, const SceneEstimate& result)
{
    auto out = std::back_inserter(csv);
    for (std::size_t i = 0; i < kBins; ++i) {
        fmt::format_to(out, "{},{},{:+.1f},", scene.run, scene.time,
                       binCentre(static_cast<int>(i)));
        if (result.estimate) {
            const TerrainEstimate& e = *result.estimate;
            const auto ceiling =
                std::isfinite(e.ceiling[i]) ? std::optional(e.ceiling[i]) : std::nullopt;
            fmt::format_to(out, "{},{},{},{},{},{},{},{},", e.mean[i], e.sd[i], e.q10[i], e.q90[i],
                           name(e.origin[i]), shown(ceiling), e.rhat[i], e.ess[i]);
        } else {
            fmt::format_to(out, ",,,,,,,,");
        }
        fmt::format_to(out, "{},{}\n", shown(scene.truth[i]), field(result.note));
    }
}

}  // namespace

std::string estimateCsv(const std::vector<Scene>& scenes,
                        const std::vector<SceneEstimate>& estimates)
{
    if (scenes.size() != estimates.size()) throw std::invalid_argument("one estimate per scene");
    std::string csv =
        "run,t_s,bin_m,mean_m,sd_m,q10_m,q90_m,source,ceiling_m,rhat,ess,truth_m,note\n";
    for (std::size_t k = 0; k < scenes.size(); ++k) addRows(csv, scenes[k], estimates[k]);
    return csv;
}

}  // namespace terratact
