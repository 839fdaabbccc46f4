#include "app/modelling/estimate_csv.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "core/base/message.h"
#include "core/infer/verdict/bimodality.h"
#include "core/infer/verdict/estimate_text.h"
#include "core/infer/verdict/obstacle.h"
#include "core/infer/verdict/verdict.h"
#include "core/store/csv_text.h"

namespace terratact {

namespace {

// Columns of the file that estimateCsv() returns.
constexpr std::size_t kTruthColumn = 11;
constexpr std::size_t kNote = 12;
constexpr std::size_t kColumns = 23;

/// Returns a note without commas and quotes, for programs that split lines at commas.
std::string noteText(std::string text)
{
    for (char& c : text)
        if (c == ',' || c == '"') c = ':';
    return text;
}

/// Quantities computed from the draws, per bin; empty without draws.
struct Hidden {
    std::array<CsvValue, kBins> step, stepSd, twoModes;
};

Hidden hiddenIn(const TerrainEstimate& estimate)
{
    Hidden hidden;
    if (estimate.draws.empty()) return hidden;
    const auto steps = stepProbabilities(estimate, kStepLimit);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        hidden.step[i] = steps[i].p;
        hidden.stepSd[i] = steps[i].monteCarloSd;
    }
    const auto modes = twoModes(estimate);
    for (std::size_t i = 0; i < kBins; ++i) hidden.twoModes[i] = modes[i].has_value();
    return hidden;
}

void addRows(std::string& csv, const Scene& scene, const TerrainEstimate& e,
             const std::string& note)
{
    const Hidden hidden = hiddenIn(e);
    const Verdict verdict = verdictOf(e, scene.s, kStepLimit);
    for (std::size_t i = 0; i < kBins; ++i)
        csv += csvLine({scene.run,
                        scene.time,
                        signedTenth(binCentre(static_cast<int>(i))),
                        e.mean[i],
                        e.sd[i],
                        e.q10[i],
                        e.q90[i],
                        name(e.origin[i]),
                        std::isfinite(e.ceiling[i]) ? CsvValue(e.ceiling[i]) : CsvValue(),
                        e.rhat[i],
                        e.ess[i],
                        scene.truth[i],
                        noteText(note),
                        e.height[i],
                        hidden.step[i],
                        hidden.stepSd[i],
                        hidden.twoModes[i],
                        e.novelty,
                        e.draws.size(),
                        name(e.ending),
                        name(e.touch[i]),
                        fixed(verdict.feltTo, 2),
                        name(verdict.stepVerdict)});
}

/// Adds the rows of a scene that could not be estimated.
void addRows(std::string& csv, const Scene& scene, const std::string& note)
{
    for (std::size_t i = 0; i < kBins; ++i) {
        std::array<CsvValue, kColumns> fields{scene.run, scene.time,
                                              signedTenth(binCentre(static_cast<int>(i)))};
        fields[kTruthColumn] = scene.truth[i];
        fields[kNote] = noteText(note);
        csv += csvLine(fields);
    }
}

}  // namespace

std::string estimateCsv(const std::vector<Scene>& scenes,
                        const std::vector<SceneEstimate>& estimates)
{
    return estimateCsvHeader() + estimateCsvRows(scenes, estimates);
}

std::string estimateCsvHeader()
{
    return "run,t_s,bin_m,mean_m,sd_m,q10_m,q90_m,source,ceiling_m,rhat,ess,truth_m,note,"
           "height_m,p_step,p_step_sd,two_modes,novelty,draws,ending,touch,horizon_m,verdict\n";
}

std::string estimateCsvRows(std::span<const Scene> scenes, std::span<const SceneEstimate> estimates)
{
    if (scenes.size() != estimates.size()) throw std::invalid_argument("one estimate per scene");
    std::string csv;
    for (std::size_t k = 0; k < scenes.size(); ++k)
        if (const auto& estimate = estimates[k].estimate)
            addRows(csv, scenes[k], *estimate, estimates[k].note);
        else
            addRows(csv, scenes[k], estimates[k].note);
    return csv;
}

}  // namespace terratact
