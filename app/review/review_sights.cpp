#include "app/review/review_sights.h"

#include <limits>

#include "app/mission/estimation.h"
#include "app/pages/force_arrays.h"
#include "widgets/base/words.h"

namespace terratact {
namespace {

ProbeProposal proposalOf(const ProposalRow& row)
{
    ProbeProposal p{.id = static_cast<quint64>(row.id),
                    .bin = row.bin,
                    .height = row.height,
                    .q10 = row.q10,
                    .q90 = row.q90,
                    .sd = row.sd,
                    .limit = row.limit,
                    .armSd = row.armSd,
                    .seconds = row.seconds,
                    .stepLimit = row.stepLimit,
                    .bitsBefore = row.bitsBefore,
                    .worth = {},
                    .others = {}};
    for (const OfferedBin& offer : row.offers) {
        const ProbeWorth worth{offer.bin, offer.varianceShare, offer.bitsAfter};
        if (offer.bin == row.bin)
            p.worth = worth;
        else
            p.others.push_back(worth);
    }
    return p;
}

bool isHeard(const ReviewMoment& moment)
{
    return moment.linkAlive && moment.measurement
        && secondsOf(moment.time - moment.measured) <= kStaleAfter;
}

}  // namespace

ReviewSights::ReviewSights(SessionReader& session, const RobotModel& robot)
    : robot_(robot), felt_(session, robot), ghost_(session, robot)
{
}

double ReviewSights::limit(const ReviewMoment& moment) const
{
    return limit_.value_or(moment.estimate ? moment.estimate->stepLimit : kStepLimit);
}

std::optional<Verdict> ReviewSights::verdict(const ReviewMoment& moment) const
{
    if (!moment.estimate || !moment.scene) return std::nullopt;
    return verdictOf(moment.estimate->estimate, moment.scene->measurement,
                     {.heard = isHeard(moment),
                      .unbroken = moment.unbroken,
                      .sensorsSound = moment.sensorsSound},
                     limit(moment));
}

double ReviewSights::threshold(const ReviewMoment& moment, const Preferences& preferences)
{
    return moment.estimate ? moment.estimate->estimate.settings.forceThreshold
                           : preferences.forceThreshold;
}

TerrainSight ReviewSights::terrain(const ReviewMoment& moment,
                                   const std::optional<TerrainEstimate>& whatIf,
                                   const Preferences& preferences)
{
    TerrainSight sight{.now = secondsOf(moment.time)};
    sight.count = ++shows_;  // every moment is drawn anew
    addMeasured(sight, moment, threshold(moment, preferences));
    addEstimates(sight, moment, whatIf);
    addGhost(sight, moment);
    sight.state = moment.state;
    sight.secondsInPhase = sight.now - moment.state.since;
    addProbe(sight, moment, preferences.probes);
    sight.preconditions << Precondition{Precondition::Level::Missing,
                                        tr("A review commands no robot")};
    sight.driving = sight.preconditions;
    return sight;
}

void ReviewSights::addMeasured(TerrainSight& sight, const ReviewMoment& moment, double threshold)
{
    if (moment.measurement) {
        sight.measurement = &*moment.measurement;
        sight.age = secondsOf(moment.time - moment.measured);
        forces_ = ForceArrays(robot_).of(*moment.measurement, moment.line, threshold);
        sight.forces = &forces_;
        forcesBefore_ = felt_.before(moment.time, threshold);
        sight.forcesBefore = &forcesBefore_;
    }
    if (!moment.scene) return;
    sight.scene = &moment.scene->measurement;
    sight.sceneTruth = &moment.scene->truth;
    if (!sight.measurement) {
        sight.measurement = sight.scene;
        sight.age = std::numeric_limits<double>::infinity();  // nothing was heard yet
    }
}

void ReviewSights::addEstimates(TerrainSight& sight, const ReviewMoment& moment,
                                const std::optional<TerrainEstimate>& whatIf) const
{
    const EstimateRow* const row = moment.estimate.get();
    if (row) {
        sight.estimate = &row->estimate;
        sight.estimateSeconds = row->seconds;
        sight.verdict = verdict(moment);
    }
    if (whatIf && row) {
        sight.second = &*whatIf;
        sight.secondName = tr("what if: %1").arg(words::text(name(whatIf->settings.method)));
    } else if (moment.second) {
        sight.second = &moment.second->estimate;
        sight.secondName = words::text(name(moment.second->estimate.settings.method));
    }
    sight.whyNoEstimate = moment.forgotten.empty() ? tr("No estimate stood at this time")
                                                   : words::sentence(moment.forgotten);
}

void ReviewSights::addGhost(TerrainSight& sight, const ReviewMoment& moment)
{
    const auto [ghost, why] = ghost_.at(moment);
    if (!ghost && !why) return;
    sight.whyNoGhost = noGhostWords(why, isHeard(moment));
    if (sight.whyNoGhost.isEmpty()) sight.ghost = ghost;
}

void ReviewSights::addProbe(TerrainSight& sight, const ReviewMoment& moment, ProbePolicy policy)
{
    const ProposalRow* const row = moment.proposal;
    const auto seconds = row ? std::optional(row->seconds) : std::nullopt;
    sight.time = phaseTime(moment.state, sight.now, AtemLimits{}, {.press = {}, .probe = seconds});
    if (row) {
        proposal_ = proposalOf(*row);
        sight.proposal = &*proposal_;
        sight.probeSeconds = row->seconds;
        if (moment.state.phase == AtemPhase::Probing) sight.probingBin = row->bin;
    } else if (moment.estimate) {
        sight.bestProbe =
            bestProbe({moment.estimate->estimate, adviceOf(moment.estimate, limit(moment)), robot_,
                       ProbeProposal{}.seconds, policy});
    }
}

const ProbeAdvice& ReviewSights::adviceOf(const std::shared_ptr<const EstimateRow>& estimate,
                                          double limit)
{
    if (advised_ != estimate || advice_.stepLimit != limit) {
        advised_ = estimate;
        advice_ = adviseProbe(advised_->estimate, robot_, limit);
    }
    return advice_;
}

}  // namespace terratact
