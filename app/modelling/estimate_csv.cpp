#include "app/modelling/estimate_csv.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "core/infer/verdict/bimodality.h"
#include "core/infer/verdict/estimate_text.h"
#include "core/infer/verdict/obstacle.h"
#include "core/infer/verdict/verdict.h"
#include "core/store/csv_text.h"

namespace terratact {

namespace {

std::string shown(std::optional<double> value)
{
    return value ? fmt::format("{}", *value) : std::string();
}

/// Returns a note without commas and quotes, for programs that split lines at commas.
std::string noteField(std::string text)
{
    for (char& c : text)
        if (c == ',' || c == '"' || c == ';') c = ':';
    return csvField(text);
}

/// Quantities computed from the draws, as CSV fields per bin.
struct Hidden {
    std::array<std::string, kBins> step, twoModes;
};

Hidden hiddenIn(const SceneEstimate& result)
{
    Hidden hidden;
    for (std::string& step : hidden.step) step = ',';
    if (!result.estimate || result.estimate->draws.empty()) return hidden;
    const auto steps = stepProbabilities(*result.estimate, kStepLimit);
    for (std::size_t i = 0; i < steps.size(); ++i)
        hidden.step[i] = fmt::format("{},{}", steps[i].p, steps[i].monteCarloSd);
    const auto modes = twoModes(*result.estimate);
    for (std::size_t i = 0; i < kBins; ++i) hidden.twoModes[i] = modes[i] ? '1' : '0';
    return hidden;
}

/// Returns felt horizon and verdict, which are the same for every bin of a scene.
std::string answerTo(const Scene& scene, const SceneEstimate& result)
{
    if (!result.estimate) return ",,";
    const Verdict verdict = verdictOf(*result.estimate, scene.s, kStepLimit);
    return fmt::format(",{:.2f},{}", verdict.horizon, name(verdict.stepVerdict));
}

void addRows(std::string& csv, const Scene& scene, const SceneEstimate& result)
{
    auto out = std::back_inserter(csv);
    const Hidden hidden = hiddenIn(result);
    const std::string answer = answerTo(scene, result);
    for (std::size_t i = 0; i < kBins; ++i) {
        fmt::format_to(out, "{},{},{:+.1f},", csvField(scene.run), scene.time,
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
        fmt::format_to(out, "{},{},", shown(scene.truth[i]), noteField(result.note));
        if (result.estimate)
            fmt::format_to(out, "{},{},{},{},{},{}", result.estimate->height[i], hidden.step[i],
                           hidden.twoModes[i], result.estimate->novelty,
                           result.estimate->draws.size(), name(result.estimate->ending));
        else
            fmt::format_to(out, ",,,,,,");
        fmt::format_to(out, ",{}{}\n",
                       result.estimate ? name(result.estimate->touch[i]) : std::string_view(),
                       answer);
    }
}

}  // namespace

std::string estimateCsv(const std::vector<Scene>& scenes,
                        const std::vector<SceneEstimate>& estimates)
{
    if (scenes.size() != estimates.size()) throw std::invalid_argument("one estimate per scene");
    std::string csv =
        "run,t_s,bin_m,mean_m,sd_m,q10_m,q90_m,source,ceiling_m,rhat,ess,truth_m,note,"
        "height_m,p_step,p_step_sd,two_modes,novelty,draws,ending,touch,horizon_m,verdict\n";
    for (std::size_t k = 0; k < scenes.size(); ++k) addRows(csv, scenes[k], estimates[k]);
    return csv;
}

}  // namespace terratact
