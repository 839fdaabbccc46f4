#include "core/infer/sampling/scene_sampling.h"

#include <utility>

#include "core/infer/estimate/hazards.h"

namespace terratact {

TerrainEstimate estimateFrom(SceneSampling sampling, const GibbsDraws& draws, const Watch& watch)
{
    TerrainEstimate& estimate = sampling.estimate;
    const Poll poll = pollOf(watch);
    for (std::size_t k = 0; k < draws.bins.size(); ++k) {
        const int bin = draws.bins[k];
        summariseDraws(estimate, bin, draws.draws[k],
                       estimate.origin[static_cast<std::size_t>(bin)], sampling.centre, poll);
        warnIfMended(estimate, bin, sampling.process(bin));
    }
    conclude(estimate, draws, sampling.known, poll);
    writeTouch(estimate, sampling.pressed);
    addHazards(estimate, estimate.settings.hazardRate, poll);
    return finite(std::move(estimate), poll);
}

TerrainEstimate sampleScene(SceneSampling sampling, const Watch& watch)
{
    const GibbsDraws draws = sampleStates(*sampling.conditionals, sampling.problem, watch);
    return estimateFrom(std::move(sampling), draws, watch);
}

}  // namespace terratact
