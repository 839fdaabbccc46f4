#include "core/infer/estimate_batch.h"

#include <utility>

#include "core/infer/estimate/missing_sensors.h"

namespace terratact {

EstimateBatch::InWork::InWork(std::size_t ofScene, SceneSampling prepared, const Watch& who)
    : number(ofScene), sampling(std::move(prepared)), watch(who),
      run(*sampling.conditionals, sampling.problem, watch)
{
}

bool EstimateBatch::hasRoomFor(const Settings& settings) const
{
    if (!ready_.empty()) return false;
    if (scenes_.empty()) return true;
    if (settings.scan == ScanOrder::Random) return false;  // every scene has its own order
    const bool fewRows = settings.inducing > 0 && settings.inducing <= kFewRows;
    if (fewRows && settings.chains % kGroup == 0) return false;
    int chains = settings.chains;
    for (const InWork& scene : scenes_) chains += scene.run.chains();
    return chains <= kBatchChains;
}

void EstimateBatch::add(std::size_t number, const Proprioception& s,
                        std::span<const ArmReading> arm, const Settings& settings,
                        const Watch& watch)
{
    if (isClosedForm(methodWithout(settings.method, missingFor(settings.method, s))))
        ready_.push_back({number, closedFormEstimate(s, arm, robot_, models_, settings, watch)});
    else
        scenes_.emplace_back(number, sceneSampling(s, arm, robot_, models_, settings, watch),
                             watch);
}

void EstimateBatch::collect()
{
    for (auto scene = scenes_.begin(); scene != scenes_.end();) {
        if (!scene->run.ended()) {
            ++scene;
            continue;
        }
        ready_.push_back({scene->number, estimateFrom(std::move(scene->sampling),
                                                      scene->run.consumeDraws(), scene->watch)});
        scene = scenes_.erase(scene);
    }
}

std::vector<EstimateBatch::Ready> EstimateBatch::next()
{
    std::vector<GibbsRun*> runs;
    collect();  // collects scenes that have nothing to sample
    for (InWork& scene : scenes_) runs.push_back(&scene.run);
    while (ready_.empty() && !runs.empty()) {
        GibbsRun::sweepTogether(runs, room_);
        collect();
    }
    return std::exchange(ready_, {});
}

}  // namespace terratact
