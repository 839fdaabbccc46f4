#include "app/modelling/truth/truth_sampling.h"

#include <algorithm>

namespace terratact {
namespace {

void putSide(const SideTruth& found, OptionalHeights& heights, OptionalHeights& sds)
{
    for (std::size_t i = 0; i < kBins; ++i) {
        heights.at(i) = found.at(i).height;
        sds.at(i) = found.at(i).height ? std::optional(found.at(i).sd) : std::nullopt;
    }
}

}  // namespace

void sampleTruth(SceneTruth& scene, const RobotModel& robot, const SceneGrid& grid,
                 std::size_t place, const TruthRule& rule)
{
    bool any = false;
    for (const Side side : {Side::Left, Side::Right}) {
        SideTruth& found = scene.side.at(indexOf(side));
        found = sideTruth(grid, robot, place, side, scene.correction, rule);
        any = any || std::ranges::any_of(found, [](const BinTruth& bin) {
                  return bin.height.has_value();
              });
    }
    scene.plane = planeTruth(scene.side[0], scene.side[1], rule);
    scene.gap = any ? TruthGap::None : TruthGap::NoCloud;
}

void putTruth(LaserTruth& truth, std::size_t row)
{
    const SceneTruth& scene = truth.truths[row];
    if (truth.isPlane)
        return putSide(scene.plane, truth.plane[row].truth, truth.plane[row].truthSd);
    for (const std::size_t side : {0U, 1U})
        putSide(scene.side.at(side), truth.tracks[row].truth.at(side),
                truth.tracks[row].truthSd.at(side));
}

}  // namespace terratact
