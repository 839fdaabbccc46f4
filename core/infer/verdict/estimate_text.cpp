#include "core/infer/verdict/estimate_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/text.h"
#include "core/infer/verdict/bimodality.h"
#include "core/infer/verdict/obstacle.h"

namespace terratact {

namespace {

std::string stepSentence(const TerrainEstimate& estimate, double limit)
{
    const StepProbability any = anyStep(estimate, limit, kFirstAhead);
    const auto pairs = stepProbabilities(estimate, limit);
    const auto likeliest = std::max_element(pairs.begin() + kFirstAhead, pairs.end(),
                                            [](const auto& a, const auto& b) { return a.p < b.p; })
                         - pairs.begin();
    return fmt::format("a step ahead of more than {:.0f} mm: probability {:.2f} ± {}, likeliest "
                       "between {:+.1f} and {:+.1f} m ({:.2f})",
                       1000.0 * limit, any.p, randomErrorText(any.monteCarloSd, 2),
                       binCentre(static_cast<int>(likeliest)),
                       binCentre(static_cast<int>(likeliest) + 1),
                       pairs[static_cast<std::size_t>(likeliest)].p);
}

}  // namespace

std::vector<std::string> hiddenByBands(const TerrainEstimate& estimate, double limit)
{
    if (estimate.draws.empty()) return {};
    std::vector<std::string> sentences{stepSentence(estimate, limit)};
    const auto modes = twoModes(estimate);
    for (std::size_t i = 0; i < kBins; ++i)
        if (modes[i])
            sentences.push_back(fmt::format(
                "two heights are likely at {:+.1f} m: {:+.2f} m ({:.0f} %) or {:+.2f} m ({:.0f} %)",
                binCentre(static_cast<int>(i)), modes[i]->lowMean, 100.0 * modes[i]->lowShare,
                modes[i]->highMean, 100.0 * modes[i]->highShare));
    return sentences;
}

}  // namespace terratact
