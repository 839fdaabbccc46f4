#include "app/mission/probe_proposals.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "app/mission/preconditions.h"
#include "core/atem/probe/arm_choice.h"
#include "core/atem/probe/probe_grounds.h"

namespace terratact {
namespace {

ProbeWorth worthOf(const ProbeGain& gain, const Uncertainty& before)
{
    const double share = before.variance > 0.0 ? gain.varianceReduction / before.variance : 0.0;
    return {.bin = gain.bin,
            .varianceShare = std::clamp(share, 0.0, 1.0),
            .bitsAfter = std::max(0.0, before.entropy - gain.entropyReduction) / std::numbers::ln2,
            .side = gain.side};
}

double sdAt(const TwoTrackEstimate& estimate, ProbePlace place)
{
    return sideOf(estimate, place.side).sd[static_cast<std::size_t>(place.bin)];
}

/// Returns the unread place in the arm's reach with the largest sd.
std::optional<ProbePlace> leastCertain(const ProbeBasis& basis)
{
    std::optional<ProbePlace> widest;
    for (const ProbeSide side : sidesToProbe(basis.estimate))
        for (int bin = 0; bin < kBins && basis.robot.armSd > 0.0; ++bin) {
            const auto i = static_cast<std::size_t>(bin);
            const Origin origin = sideOf(basis.estimate, side).origin[i];
            if (!basis.robot.armReaches(bin, side) || origin == Origin::Arm) continue;
            if (!widest || sdAt(basis.estimate, {bin, side}) > sdAt(basis.estimate, *widest))
                widest = {bin, side};
        }
    return widest;
}

/// Returns a place of the estimate's kind, see ProbeProposals::propose().
ProbePlace placeOn(const TwoTrackEstimate& estimate, ProbePlace place)
{
    if (estimate.onePlane) return {place.bin, ProbeSide::Middle};
    if (place.side != ProbeSide::Middle) return place;
    const ProbePlace left{place.bin, ProbeSide::Left}, right{place.bin, ProbeSide::Right};
    return sdAt(estimate, right) > sdAt(estimate, left) ? right : left;
}

}  // namespace

ProbeProposal describeProbe(const ProbeBasis& basis, ProbePlace place)
{
    const auto& [both, advice, robot, seconds, policy] = basis;
    const TerrainEstimate& estimate = sideOf(both, place.side);
    const auto i = static_cast<std::size_t>(place.bin);
    ProbeProposal probe{.id = 0,
                        .bin = place.bin,
                        .side = place.side,
                        .height = estimate.height[i],
                        .q10 = estimate.q10[i],
                        .q90 = estimate.q90[i],
                        .sd = estimate.sd[i],
                        .limit = estimate.settings.probeAbove,
                        .armSd = robot.armSd,
                        .seconds = seconds,
                        .stepLimit = advice.stepLimit,
                        .bitsBefore = advice.before.entropy / std::numbers::ln2,
                        .worth = {},
                        .others = {}};
    for (const ProbeGain& gain : ranked(advice, policy)) {
        const ProbeWorth worth = worthOf(gain, advice.before);
        if (gain.place() == place)
            probe.worth = worth;
        else
            probe.others.push_back(worth);
    }
    return probe;
}

std::optional<ProbeProposal> bestProbe(const ProbeBasis& basis)
{
    const std::vector<ProbeGain> gains = ranked(basis.advice, basis.policy);
    const bool isRanked = basis.policy == ProbePolicy::Question && !gains.empty();
    if (basis.advice.place && !isRanked) return describeProbe(basis, *basis.advice.place);
    if (!gains.empty()) return describeProbe(basis, gains.front().place());
    if (basis.advice.stepLimit <= 0.0) return std::nullopt;  // no advice yet
    const std::optional<ProbePlace> widest = leastCertain(basis);
    return widest ? std::optional(describeProbe(basis, *widest)) : std::nullopt;
}

Message whyNoBestProbe(const ProbeBasis& basis)
{
    if (!(basis.robot.armSd > 0.0))
        return TR_NOOP("ProbeProposals", "no probe: the arm measures no height");
    if (basis.advice.stepLimit <= 0.0)
        return TR_NOOP("ProbeProposals", "the gain of a probe is being computed");
    return TR_NOOP("ProbeProposals", "no probe: no bin in reach is left");
}

ProbeProposals::ProbeProposals(const Estimation& estimation, const RobotModel& robot,
                               double seconds, const ProbePolicy& policy)
    : estimation_(estimation), robot_(robot), seconds_(seconds), policy_(policy)
{
}

ProbeOffer ProbeProposals::offer(ProbePolicy policy) const
{
    return offerProbe(estimation_.advice(), estimation_.verdict()->both, policy);
}

ProbeBasis ProbeProposals::basis() const
{
    return {*estimation_.estimate(), estimation_.advice(), robot_, seconds_, policy_};
}

std::optional<ProbeProposal> ProbeProposals::best() const
{
    if (!estimation_.estimate() || estimation_.wasPitchSuspected()) return std::nullopt;
    return bestProbe(basis());
}

Message ProbeProposals::whyNoBest() const
{
    if (!estimation_.estimate()) return {};
    if (estimation_.wasPitchSuspected()) return Preconditions::pitchSuspected().text;
    return whyNoBestProbe(basis());
}

void ProbeProposals::propose(ProbePlace place)
{
    current_ = describeProbe(basis(), placeOn(*estimation_.estimate(), place));
    current_->id = ++last_;
    proposedOn_ = grounds();
}

bool ProbeProposals::stands() const
{
    const std::string now = grounds();
    return !now.empty() && now == proposedOn_;
}

std::string ProbeProposals::grounds() const
{
    const auto& scene = estimation_.scene();
    const auto& estimate = estimation_.estimate();
    if (!scene || !estimate || !current_ || estimation_.hadTelemetryGap()) return {};
    const ModelInUse& model = estimation_.model();
    return fingerprint({.scene = scene->measurement,
                        .readings = estimation_.readings(),
                        .settings = estimate->side[0].settings,
                        .wanted = estimation_.wanted(),
                        .model = (model.name + model.details).toStdString(),
                        .bin = current_->bin,
                        .side = current_->side});
}

}  // namespace terratact
