#include "app/review/review_view_state.h"

#include <limits>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/estimation.h"
#include "app/mission/memory_text.h"
#include "app/pages/force_arrays.h"

namespace terratact {
namespace {

ProbeProposal proposalOf(const ProposalRow& row)
{
    ProbeProposal p{.id = static_cast<quint64>(row.id),
                    .bin = row.bin,
                    .side = row.side,
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
        const ProbeWorth worth{offer.bin, offer.varianceShare, offer.bitsAfter, offer.side};
        if (offer.bin == row.bin && offer.side == row.side)
            p.worth = worth;
        else
            p.others.push_back(worth);
    }
    return p;
}

bool isTelemetryFresh(const ReviewMoment& moment)
{
    return moment.linkAlive && moment.measurement
        && secondsOf(moment.time - moment.measured) <= kStaleAfter;
}

}  // namespace

ReviewViewState::ReviewViewState(SessionReader& session, const RobotModel& robot)
    : robot_(robot), felt_(session, robot), strip_(session, robot)
{
}

double ReviewViewState::limit(const ReviewMoment& moment) const
{
    return limit_.value_or(moment.estimate ? moment.estimate->stepLimit : kStepLimit);
}

std::optional<TwoTrackVerdict> ReviewViewState::verdict(const ReviewMoment& moment) const
{
    if (!moment.estimate || !moment.scene) return std::nullopt;
    return verdictOf(moment.estimate->estimate, robot_, moment.scene->measurement,
                     {.telemetryFresh = isTelemetryFresh(moment),
                      .unbroken = moment.unbroken,
                      .sensorsSound = moment.sensorsSound},
                     limit(moment));
}

double ReviewViewState::threshold(const ReviewMoment& moment, const Preferences& preferences)
{
    return moment.estimate ? moment.estimate->estimate.side[0].settings.forceThreshold
                           : preferences.forceThreshold;
}

TerrainViewState ReviewViewState::terrain(const ReviewMoment& moment,
                                          const Revised<TwoTrackEstimate>& whatIf,
                                          const Preferences& preferences)
{
    TerrainViewState viewState{.now = secondsOf(moment.time)};
    viewState.count = ++shows_;  // every moment is redrawn
    addMeasured(viewState, moment, preferences);
    addEstimates(viewState, moment, whatIf);
    addRemembered(viewState, moment);
    viewState.state = moment.state;
    viewState.secondsInPhase = viewState.now - moment.state.since;
    addProbe(viewState, moment, preferences.probes);
    viewState.preconditions << Precondition{
        Precondition::Level::Missing, TR_NOOP("ReviewViewState", "A review commands no robot")};
    viewState.driving = viewState.feeling = viewState.preconditions;
    return viewState;
}

void ReviewViewState::addMeasured(TerrainViewState& viewState, const ReviewMoment& moment,
                                  const Preferences& preferences)
{
    const double force = threshold(moment, preferences);
    if (moment.measurement) {
        viewState.measurement = &*moment.measurement;
        viewState.age = secondsOf(moment.time - moment.measured);
        viewState.attitude = attitudeOf(*moment.measurement, robot_, preferences.tilt());
        forces_ = ForceArrays(robot_).of(*moment.measurement, moment.forces, force);
        viewState.forces = &forces_;
        forcesBefore_ = felt_.before(moment.time, force);
        viewState.forcesBefore = &forcesBefore_;
    }
    if (!moment.scene) return;
    viewState.scene = &moment.scene->measurement;
    viewState.sceneTruth = &moment.scene->truth;
    viewState.sceneSideTruth = &moment.scene->sideTruth;
    if (!viewState.measurement) {
        viewState.measurement = viewState.scene;
        viewState.age = std::numeric_limits<double>::infinity();  // nothing was received yet
    }
}

void ReviewViewState::addEstimates(TerrainViewState& viewState, const ReviewMoment& moment,
                                   const Revised<TwoTrackEstimate>& whatIf) const
{
    const EstimateRow* const row = moment.estimate.get();
    if (row) {
        viewState.estimate = {&row->estimate, revisionOf(row)};
        viewState.estimateSeconds = row->seconds;
        viewState.verdict = verdict(moment);
    }
    if (whatIf && row) {
        // A revision that no recorded estimate has.
        viewState.second = {&*whatIf, 2 * whatIf.revision() + 1};
        viewState.secondName =
            tr("what if: %1").arg(format::text(name(whatIf->side[0].settings.method)));
    } else if (moment.second) {
        viewState.second = {&moment.second->estimate, 2 * revisionOf(moment.second.get())};
        viewState.secondName = format::text(name(moment.second->estimate.side[0].settings.method));
    }
    viewState.whyNoEstimate =
        moment.forgotten.empty() ? tr("No estimate at this time") : translated(moment.forgotten);
}

void ReviewViewState::addRemembered(TerrainViewState& viewState, const ReviewMoment& moment)
{
    ReviewStrip::ViewState found = strip_.at(moment);
    const bool isFresh = isTelemetryFresh(moment);
    if (isFresh) viewState.remembered = std::move(found.seen);
    viewState.earlier = std::move(found.earlier);
    viewState.whyNothingRemembered =
        translated(nothingRememberedText(found.why, isFresh).value_or(Message()));
    const EstimateRow* const row = moment.estimate.get();
    if (!row) return;
    const bool hasMemory = moment.scene && moment.scene->memory;
    const Message memory =
        hasMemory ? memoryText(row->estimate, &*moment.scene->memory) : Message();
    viewState.memoryText = translated(found.ledger ? withLedger(memory, *found.ledger) : memory);
}

void ReviewViewState::addProbe(TerrainViewState& viewState, const ReviewMoment& moment,
                               ProbePolicy policy)
{
    const ProposalRow* const row = moment.proposal;
    const auto seconds = row ? std::optional(row->seconds) : std::nullopt;
    viewState.time =
        phaseTime(moment.state, viewState.now, AtemLimits{}, {.press = {}, .probe = seconds});
    if (row) {
        proposal_ = proposalOf(*row);
        viewState.proposal = &*proposal_;
        viewState.probeSeconds = row->seconds;
        if (moment.state.phase == AtemPhase::Probing)
            viewState.probingPlace = ProbePlace{row->bin, row->side};
    } else if (moment.estimate) {
        const ProbeBasis basis{moment.estimate->estimate, adviceOf(moment.estimate, limit(moment)),
                               robot_, ProbeProposal{}.seconds, policy};
        viewState.bestProbe = bestProbe(basis);
        if (!viewState.bestProbe) viewState.whyNoBestProbe = translated(whyNoBestProbe(basis));
    }
}

const ProbeAdvice& ReviewViewState::adviceOf(const std::shared_ptr<const EstimateRow>& estimate,
                                             double limit)
{
    if (advised_ != estimate || advice_.stepLimit != limit) {
        advised_ = estimate;
        advice_ = adviseProbe(advised_->estimate, robot_, limit);
    }
    return advice_;
}

}  // namespace terratact
