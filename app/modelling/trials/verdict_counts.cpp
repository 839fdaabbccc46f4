#include "app/modelling/trials/verdict_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/modelling/simulation/hazard_scenes.h"
#include "core/terrain/step.h"

namespace terratact {
namespace {

void countBands(const TerrainEstimate& estimate, const Heights& truth, VerdictCounts& counts)
{
    for (std::size_t i = 0; i < kBins; ++i) {
        const bool covered = truth[i] >= estimate.q10[i] && truth[i] <= estimate.q90[i];
        const bool felt =
            isFeltThrough(estimate.touch[i]) || estimate.touch[i] == Touch::FeltInPart;
        if (felt) {
            ++counts.feltBins;
            counts.feltCovered += covered ? 1 : 0;
        } else if (static_cast<int>(i) >= kFirstAhead) {
            ++counts.unfeltBins;
            counts.unfeltCovered += covered ? 1 : 0;
        }
    }
}

double share(std::size_t part, std::size_t whole, double of)
{
    return whole == 0 ? 0.0 : of * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

const std::string_view kCountsHead =
    "                               scenes   step BLOCKED  CLEAR  false  per 1k   flat  "
    "flat%  press press% felt80  unf80 contra\n";

const std::string_view kCountsLegend =
    R"(step: a true step ahead; false: CLEAR with a true step before its horizon, per 1k of the scenes with a step ahead
flat: the true ground from the rear bin to the front flippers' reach is flat, flat%: CLEAR of these scenes
felt80, unf80: cover of the 80 % bands of felt bins, and of bins ahead that are not felt [%]
contra: estimates that contradict their readings: their verdict is withheld
)";

VerdictCounts& VerdictCounts::operator+=(const VerdictCounts& o)
{
    scenes += o.scenes;
    failed += o.failed;
    contradicting += o.contradicting;
    withStep += o.withStep;
    clear += o.clear;
    blocked += o.blocked;
    falseClear += o.falseClear;
    overlooked += o.overlooked;
    flat += o.flat;
    flatClear += o.flatClear;
    pressed += o.pressed;
    pressedClear += o.pressedClear;
    feltBins += o.feltBins;
    feltCovered += o.feltCovered;
    unfeltBins += o.unfeltBins;
    unfeltCovered += o.unfeltCovered;
    return *this;
}

int reachOf(const TerrainEstimate& estimate)
{
    int last = kMinHorizonBin;
    for (int bin = kFirstAhead; bin < kBins; ++bin)
        if (std::isfinite(estimate.ceiling[static_cast<std::size_t>(bin)]))
            last = std::max(last, bin);
    return last;
}

int lastBinOf(const Verdict& verdict)
{
    return static_cast<int>(std::lround((verdict.horizon - binBegin(0)) / kBinWidth)) - 1;
}

VerdictCounts countVerdict(const Verdict& verdict, const TerrainEstimate& estimate,
                           const Heights& truth, double stepLimit)
{
    const bool clear = verdict.stepVerdict == StepVerdict::Clear;
    const bool stepAhead = hasStep(truth, stepLimit, kFirstAhead, kBins - 1);
    const bool stepBefore = clear && hasStep(truth, stepLimit, kFirstAhead, lastBinOf(verdict));
    const bool flat = isFlatTo(truth, stepLimit, reachOf(estimate));
    VerdictCounts counts;
    counts.scenes = 1;
    counts.contradicting = estimate.contradicts ? 1 : 0;
    counts.withStep = stepAhead ? 1 : 0;
    counts.clear = clear ? 1 : 0;
    counts.blocked = verdict.stepVerdict == StepVerdict::Blocked ? 1 : 0;
    counts.falseClear = stepBefore ? 1 : 0;
    counts.overlooked = clear && stepAhead && !stepBefore ? 1 : 0;
    counts.flat = flat ? 1 : 0;
    counts.flatClear = flat && clear ? 1 : 0;
    countBands(estimate, truth, counts);
    return counts;
}

std::string countsLine(std::string_view what, const VerdictCounts& c)
{
    return fmt::format(
        "{:<30} {:>6} {:>6} {:>7} {:>6} {:>6} {:>7.2f} {:>6} {:>6.0f} {:>6} {:>6.0f} "
        "{:>6.1f} {:>6.1f} {:>6}\n",
        what, c.scenes, c.withStep, c.blocked, c.clear, c.falseClear,
        share(c.falseClear, c.withStep, 1000.0), c.flat, share(c.flatClear, c.flat, 100.0),
        c.pressed, share(c.pressedClear, c.pressed, 100.0), share(c.feltCovered, c.feltBins, 100.0),
        share(c.unfeltCovered, c.unfeltBins, 100.0), c.contradicting);
}

}  // namespace terratact
