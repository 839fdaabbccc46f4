#include "core/infer/verdict/estimate_text.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/infer/verdict/bimodality.h"
#include "core/infer/verdict/obstacle.h"

namespace terratact {

namespace {

Message stepSentence(const TerrainEstimate& estimate, double limit)
{
    const StepProbability any = anyStep(estimate, limit, kFirstAhead);
    const auto pairs = stepProbabilities(estimate, limit);
    const auto likeliest = std::max_element(pairs.begin() + kFirstAhead, pairs.end(),
                                            [](const auto& a, const auto& b) { return a.p < b.p; })
                         - pairs.begin();
    return {TR_NOOP("core", "a step of more than %1 m anywhere ahead, felt or not: P %2 ± %3, most "
                            "likely at %4 … %5 m (P %6)"),
            fixed(limit, 2),
            fixed(any.p, 2),
            randomErrorText(any.monteCarloSd, 2),
            signedFixed(binCentre(static_cast<int>(likeliest)), 1),
            signedFixed(binCentre(static_cast<int>(likeliest) + 1), 1),
            fixed(pairs[static_cast<std::size_t>(likeliest)].p, 2)};
}

}  // namespace

std::vector<Message> hiddenByBands(const TerrainEstimate& estimate, double limit)
{
    if (estimate.draws.empty()) return {};
    std::vector<Message> sentences{stepSentence(estimate, limit)};
    const auto modes = twoModes(estimate);
    for (std::size_t i = 0; i < kBins; ++i)
        if (modes[i])
            sentences.emplace_back(
                TR_NOOP("core", "two heights are likely at %1 m: %2 m (%3 %) or %4 m (%5 %)"),
                signedFixed(binCentre(static_cast<int>(i)), 1), signedFixed(modes[i]->lowMean, 2),
                fixed(100.0 * modes[i]->lowShare, 0), signedFixed(modes[i]->highMean, 2),
                fixed(100.0 * modes[i]->highShare, 0));
    return sentences;
}

}  // namespace terratact
