#include "core/strip/scene_scores.h"

#include <algorithm>

namespace terratact {

void SceneScores::beginScene()
{
    before_ = all();
    probes_ = {};
    touches_.reset();
    shown_.reset();
    scored_.clear();
}

void SceneScores::addProbes(std::span<const ArmReading> arm)
{
    if (!shown_) return;
    for (const ArmReading& reading : arm) {
        if (std::ranges::find(scored_, reading) != scored_.end()) continue;
        scored_.push_back(reading);
        const bool isBetween = !shown_->onePlane && reading.side == ProbeSide::Middle;
        const std::size_t side = reading.side == ProbeSide::Right ? 1 : 0;
        const ShownBands::Bin& bin =
            shown_->side.at(side).at(static_cast<std::size_t>(reading.bin));
        const bool isMeasured = StripLedger::canScore(bin.band, reading.height, reading.sd);
        if (isMeasured && !isBetween && !bin.isProbed)
            probes_.add(ScoredBy::Probe, bin.band, reading.height, reading.sd);
    }
}

void SceneScores::show(const TwoTrackEstimate& estimate)
{
    ShownBands& shown = shown_.emplace();
    shown.onePlane = estimate.onePlane;
    for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t i = 0; i < kBins; ++i) {
            const TerrainEstimate& e = estimate.side.at(side);
            shown.side.at(side)[i] = {{e.height[i], e.sd[i], e.q10[i], e.q90[i]},
                                      e.origin[i] == Origin::Arm};
        }
}

void SceneScores::takeBack()
{
    touches_.reset();
    shown_.reset();
}

StripLedger SceneScores::all() const
{
    StripLedger sum = before_;
    sum += probes_;
    if (touches_) sum += *touches_;
    return sum;
}

}  // namespace terratact
