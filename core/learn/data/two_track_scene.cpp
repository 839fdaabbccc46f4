#include "core/learn/data/two_track_scene.h"

#include <utility>

namespace terratact {

TwoTrackScene onBothSides(const Scene& scene)
{
    const Proprioception& s = scene.s;
    TwoTrackScene both{.run = scene.run, .time = scene.time, .s = {}, .truth = {}};
    both.s.pitch = s.pitch;
    both.s.flippers = {s.front, s.front, s.rear, s.rear};
    both.s.currents = {s.frontCurrent, s.frontCurrent, s.rearCurrent, s.rearCurrent};
    both.s.forces[indexOf(Flipper::FrontLeft)] = s.force;
    both.s.forces[indexOf(Flipper::FrontRight)] = s.force;
    both.truth = {scene.truth, scene.truth};
    both.truthSd = {scene.truthSd, scene.truthSd};
    return both;
}

std::vector<TwoTrackScene> onBothSides(const std::vector<Scene>& scenes)
{
    std::vector<TwoTrackScene> both;
    both.reserve(scenes.size());
    for (const Scene& scene : scenes) both.push_back(onBothSides(scene));
    return both;
}

TwoTrackScene mirrored(const TwoTrackScene& scene)
{
    TwoTrackScene mirror = scene;
    mirror.s = mirrored(scene.s);
    std::swap(mirror.truth[0], mirror.truth[1]);
    std::swap(mirror.truthSd[0], mirror.truthSd[1]);
    return mirror;
}

}  // namespace terratact
