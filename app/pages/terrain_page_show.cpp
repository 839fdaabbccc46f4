#include "app/pages/terrain_page.h"

#include <QLabel>
#include <QPushButton>
#include <cmath>
#include <utility>

#include "app/display/format.h"
#include "app/display/place_text.h"
#include "core/robot/side_plane.h"
#include "core/terrain/body_ceiling.h"
#include "core/terrain/outline.h"
#include "widgets/base/card.h"
#include "widgets/base/elided_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/drive_pad.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/readings/rear_view.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

// Returns the text of the probe card when another console approves probes.
QString followedProbe(const AtemState& state)
{
    if (state.phase == AtemPhase::Probing) return TerrainPage::tr("Following: the arm is probing.");
    if (state.probed)
        return TerrainPage::tr("The arm has measured; its height is part of the estimate.");
    return TerrainPage::tr("Following: probes are approved on the commanding console.");
}

/// Returns true if a verdict is CANNOT TELL, that of the robot or of a side.
bool isOpen(const TerrainViewState& viewState)
{
    return viewState.verdict && hasCannotTell(*viewState.verdict);
}

/// Returns true if a probe's worth is known, nothing is proposed and nothing is running.
bool isAtRest(const TerrainViewState& viewState)
{
    return viewState.estimate && !viewState.live && viewState.bestProbe
        && !exploring(viewState.state.phase);
}

/// Returns true if the worth of a probe may be shown: at rest, and the verdict is not withheld.
bool showsWorth(const TerrainViewState& viewState)
{
    return isAtRest(viewState) && (!viewState.verdict || !isWithheld(*viewState.verdict));
}

/// Returns what a probe of the bin would gain, in one line.
QString probeGainText(const ProbeProposal& probe)
{
    const QString place = placeText({probe.bin, probe.side});
    if (!probe.worth)
        return TerrainPage::tr("probe %1: its height, ± %2 instead of ± %3")
            .arg(place, format::length(probe.armSd, 2), format::length(probe.sd, 2));
    const QString bits = format::number(probe.bitsBefore, 2);
    return probe.informsOnStep() ? TerrainPage::tr("probe %1: %2 → %3 bit")
                                       .arg(place, bits, format::number(probe.worth->bitsAfter, 2))
                                 : TerrainPage::tr("probe %1: no gain").arg(place);
}

QString whyNoProbe(const TerrainViewState& viewState)
{
    if (isAtRest(viewState) && !showsWorth(viewState))
        return TerrainPage::tr("The verdict is withheld: do not rely on a probe's gain.");
    const AtemState& state = viewState.state;
    if (state.followed) return followedProbe(state);
    if (state.phase == AtemPhase::Presenting) {
        if (state.probed)
            return TerrainPage::tr("The arm has measured; its height is part of the estimate.");
        if (state.approvalExpired)
            return TerrainPage::tr("The proposal was not answered in time and counts as refused.");
        if (!viewState.whyNotOffered.isEmpty())
            return showsWorth(viewState)
                     ? TerrainPage::tr("%1; what one would tell:").arg(viewState.whyNotOffered)
                     : viewState.whyNotOffered;
    }
    if (showsWorth(viewState)) return TerrainPage::tr("No probe is proposed; what one would tell:");
    return TerrainPage::tr(
        "No probe is proposed. After an exploration the arm is offered where the "
        "terrain stays uncertain.");
}

/// Returns the arm's tip: the robot reports only where the arm last touched at this pose, not where it is.
std::optional<ArmTip> armTipOf(const TerrainViewState& viewState, bool asking)
{
    using State = ArmTip::State;
    if (asking)
        return ArmTip{.state = State::Proposed,
                      .bin = viewState.proposal->bin,
                      .side = viewState.proposal->side};
    if (viewState.probingPlace)
        return ArmTip{.state = State::Probing,
                      .bin = viewState.probingPlace->bin,
                      .side = viewState.probingPlace->side};
    if (!viewState.measurement || !viewState.measurement->arm) return std::nullopt;
    const ArmReading& touched = *viewState.measurement->arm;
    return ArmTip{.state = State::Touched,
                  .bin = touched.bin,
                  .height = touched.height,
                  .side = touched.side};
}

/// Returns the robot's attitude, with the cross slope ahead where both sides are estimated.
RearView::Pose rearPoseOf(const TerrainViewState& viewState)
{
    const Measurement& m = *viewState.measurement;
    RearView::Pose pose{.roll = m.roll, .frontLeft = m.frontLeft, .frontRight = m.frontRight};
    if (viewState.estimate && !viewState.estimate->onePlane && viewState.verdict)
        pose.crossSlope = viewState.verdict->crossSlope.steepest;
    return pose;
}

/// Returns the outline of one side. Body and track lie in the track's plane, the flippers in the flippers' plane.
Outline sideOutline(const RobotModel& robot, const Measurement& m, Side side)
{
    const bool isLeft = side == Side::Left;
    const double front = isLeft ? m.frontLeft : m.frontRight;
    const double rear = isLeft ? m.rearLeft : m.rearRight;
    const auto inPlane = [&](double y) {
        return robotOutline(inSidePlane(robot, m.roll, signOf(side) * y), m.pitch, front, rear);
    };
    const auto isFlipper = [](const OutlinePart& part) {
        return part.kind == OutlinePart::Kind::FrontFlipper
            || part.kind == OutlinePart::Kind::RearFlipper;
    };
    Outline outline = inPlane(robot.lateral.trackY);
    const Outline flippers = inPlane(robot.lateral.flipperY);
    for (std::size_t i = 0; i < outline.size(); ++i)
        if (isFlipper(outline[i])) outline[i] = flippers[i];
    return outline;
}

/// Returns the side that decides the robot's verdict: a blocked side, else a side that is not clear. If both are alike,
/// the larger probability of a step decides.
Side decidingSide(const TwoTrackVerdict& verdict)
{
    const auto rank = [](const Verdict& side) {
        const int answer = side.stepVerdict == StepVerdict::Blocked    ? 2
                         : side.stepVerdict == StepVerdict::CannotTell ? 1
                                                                       : 0;
        return std::pair(answer, side.step.p);
    };
    return rank(verdict.side[0]) > rank(verdict.side[1]) ? Side::Left : Side::Right;
}

/// Returns true while the flippers press. A preview stays longer, until the scene's estimate is there.
bool flippersMove(const TerrainViewState& viewState)
{
    return viewState.state.phase == AtemPhase::Pressing;
}

}  // namespace

void TerrainPage::setViewState(const TerrainViewState& viewState)
{
    showRobot(viewState);
    showDrive(viewState);
    showEstimate(viewState);
    const bool isStale = viewState.measurement && viewState.age > kStaleAfter && !viewState.ended;
    terrain_->setStale(isStale ? std::optional(viewState.age) : std::nullopt);
    showVerdict(viewState);
    showPose(viewState);  // after showVerdict(), which selects the side that is drawn in full
    showContacts(viewState);
    showProbe(viewState);
    strip_->setProgress(viewState.progress);
    atem_->setState(viewState.state, viewState.time, viewState.stateText);
    atem_->setHasResult(viewState.estimate || !viewState.remembered.isEmpty());
    showProbeToAsk(viewState);
    atem_->setPreconditions(viewState.preconditions);
    atem_->setNeeds(Commanded::Drive, viewState.driving);
    atem_->setNeeds(Commanded::Arm, viewState.arming);
    atem_->setNeeds(Commanded::Probe, viewState.probing);
    atem_->setNeeds(Commanded::ReleaseStop, viewState.releasing);
    drive_->setPreconditions(viewState.driving);
    drive_->setFeelPreconditions(viewState.feeling, viewState.state.loops);
}

void TerrainPage::showRobot(const TerrainViewState& viewState)
{
    if (!viewState.measurement) {
        readout_->clearMeasurement();
        rear_->setPose(std::nullopt);
        forces_->clearForces();
        showForcesAge(viewState);
        showRearForces(viewState);
        robotAge_->setText(QString());
        return;
    }
    const bool fresh = viewState.age <= kStaleAfter;
    if (viewState.numbersDue || fresh != numbersFresh_) {
        numbersFresh_ = fresh;
        const bool isDrawn = !viewState.scene || viewState.scene == viewState.measurement;
        readout_->setAttitude(viewState.attitude);
        rear_->setPose(fresh ? std::optional(rearPoseOf(viewState)) : std::nullopt);
        const auto captured = isDrawn ? std::nullopt : std::optional(viewState.scene->pitch);
        if (viewState.ages)
            readout_->setMeasurement(*viewState.measurement, viewState.age, *viewState.ages,
                                     captured);
        else
            readout_->setMeasurement(*viewState.measurement, viewState.age, captured);
        showAge(viewState);
    }
    if (!fresh) showAge(viewState);  // the age grows
    showForcesAge(viewState);
    showRearForces(viewState);
    if (!fresh || forcesAge_) return forces_->clearForces();
    if (viewState.count == shownCount_ || !viewState.forces) return;
    if (viewState.forcesBefore)
        forces_->setForces(*viewState.forces, viewState.now, *viewState.forcesBefore);
    else
        forces_->setForces(*viewState.forces, viewState.now);
    const QString legend = (rearButton_->isChecked() ? rearForces_ : forces_)->legend();
    if (forceLegend_->text() == legend) return;
    forceLegend_->setText(legend);
    showThreshold();
}

void TerrainPage::showAge(const TerrainViewState& viewState)
{
    const bool fresh = viewState.age <= kStaleAfter;
    const double oldest = std::ceil(10.0 * (viewState.age + viewState.numbersFor)) / 10.0;
    QString text;
    if (viewState.measurement == viewState.scene)
        text = QString();  // a scene from a file
    else if (viewState.ended)
        text = tr("the log has ended");
    else if (!fresh)
        text = tr("%1 s old").arg(format::number(viewState.age, 1));
    else if (viewState.numbersFor > 0.0)
        text = tr("< %1 s old").arg(format::number(oldest, 1));
    else
        text = tr("%1 old").arg(format::age(viewState.age));
    robotAge_->setText(text);
    setTone(*robotAge_, fresh || viewState.ended ? Tone::Muted : Tone::Bad);
}

/// Shows the age of the forces: as the card's tip while fresh, on the card when stale.
void TerrainPage::showForcesAge(const TerrainViewState& viewState)
{
    const double age = viewState.forcesAge.value_or(viewState.age);
    const bool isScene =
        !viewState.measurement || viewState.measurement == viewState.scene;  // a scene from a file
    const auto said =
        isScene || viewState.ended || age <= kStaleAfter ? std::nullopt : std::optional(age);
    if (viewState.numbersDue || said != forcesAge_)
        setTip(*thresholdText_,
               isScene ? QString() : tr("the forces are %1 old").arg(format::age(age)));
    if (said == forcesAge_) return;
    forcesAge_ = said;
    showThreshold();
}

/// Draws an estimate of the past, with nothing of the present beside it. Returns false if none is to be drawn.
bool TerrainPage::showPast(const TerrainViewState& viewState)
{
    constexpr std::uint64_t kNoRevision = ~std::uint64_t{0};
    const auto past = viewState.past.estimate.shown();
    if (std::exchange(shownPast_, past) != past) {
        shown_ = kNoRevision;  // the present estimate is redrawn afterwards
        shownLive_ = shownSecond_ = std::nullopt;
        shownCount_ = 0;
        terrain_->setSecond(std::nullopt, {});
        terrain_->setRemembered({}, {});
        terrain_->setEarlier({});
        if (past) {
            terrain_->setEstimate(*viewState.past.estimate, viewState.past.note);
            strip_->setNothing(tr("an estimate of the past"));
        }
    }
    shownEstimate_ = viewState.estimate && !viewState.live;
    return past.has_value();
}

void TerrainPage::showEstimate(const TerrainViewState& viewState)
{
    if (showPast(viewState)) return;
    const auto estimate = viewState.estimate.shown();
    const auto second = viewState.second.shown();
    if (viewState.live) {
        showPreview(viewState);
        shown_.reset();
    } else if (estimate) {
        if (shown_ != estimate) {
            terrain_->setEstimate(*viewState.estimate);
            strip_->setEstimate(*viewState.estimate, viewState.estimateSeconds,
                                viewState.memoryText);
            shown_ = estimate;
        }
    } else if (shown_ || shownLive_ || shownReason_ != viewState.whyNoEstimate) {
        shown_.reset();
        shownReason_ = viewState.whyNoEstimate;
        terrain_->clearEstimate(shownReason_);
        strip_->setNothing(QString());
    }
    terrain_->setRemembered(viewState.remembered, viewState.whyNothingRemembered);
    terrain_->setEarlier(viewState.earlier);
    if (shownSecond_ != second) {
        shownSecond_ = second;
        terrain_->setSecond(second ? std::optional(*viewState.second) : std::nullopt,
                            viewState.secondName);
    }
    shownLive_ = viewState.live.shown();
    shownEstimate_ = estimate && !viewState.live;
    if (shownEstimate_) shownReason_.clear();
}

void TerrainPage::showPreview(const TerrainViewState& viewState)
{
    const bool moves = flippersMove(viewState);
    const QString note =
        moves ? tr("The flippers still move: no ground ahead is felt yet")
              : tr("Preview while the flippers go down: the estimate is being computed");
    if (shownLive_ == viewState.live.shown() && shownReason_ == note) return;
    terrain_->setEstimate(*viewState.live, note);
    strip_->setLive(moves ? tr("LIVE preview") : tr("preview"));
    shownReason_ = note;
}

void TerrainPage::showPose(const TerrainViewState& viewState)
{
    const PastDrawing& past = viewState.past;
    if (!viewState.measurement) return clearPose();
    if (viewState.count == shownCount_) return;
    // An estimate belongs to its scene, so both are drawn in the scene's pose.
    const Measurement* const scene = past ? past.scene : viewState.scene;
    posed_ = scene ? *scene : *viewState.measurement;
    const TwoTrackEstimate* const estimate = past           ? past.estimate.estimate
                                           : viewState.live ? viewState.live.estimate
                                                            : viewState.estimate.estimate;
    isOnePlane_ = estimate ? estimate->onePlane : !sidesDiffer(twoTrackReadings(*posed_));
    showOutlines();
    const std::optional<Heights>* const truth = past            ? past.truth
                                              : viewState.scene ? viewState.sceneTruth
                                                                : viewState.truth;
    const auto* const sideTruth = past            ? past.sideTruth
                                : viewState.scene ? viewState.sceneSideTruth
                                                  : nullptr;
    // The means of both sides are those of neither.
    planeTruth_ = truth && isOnePlane_ ? *truth : std::nullopt;
    sideTruth_ = sideTruth ? *sideTruth : std::nullopt;
    showTruth();
    shownCount_ = viewState.count;
}

void TerrainPage::clearPose()
{
    if (!posed_) return;
    posed_.reset();
    planeTruth_.reset();
    sideTruth_.reset();
    terrain_->setOutline({});
    showTruth();
    shownCount_ = 0;
}

/// Draws the true heights: of two sides, those of the side in full.
void TerrainPage::showTruth()
{
    if (const auto side = terrain_->sideInFull())
        return terrain_->setTruth(sideTruth_ ? std::optional((*sideTruth_)[indexOf(*side)])
                                             : std::nullopt);
    terrain_->setTruth(planeTruth_);
}

/// Draws both sides of the robot where they differ: the right side near, and the left side behind it.
void TerrainPage::showOutlines()
{
    if (!posed_) return;
    if (isOnePlane_) {
        const Proprioception s = proprioception(*posed_);
        return terrain_->setOutline(robotOutline(robot_, s.pitch, s.front, s.rear));
    }
    const auto outline = [this](Side side) { return sideOutline(robot_, *posed_, side); };
    switch (terrain_->shownSides()) {
    case ShownSides::Left: return terrain_->setOutline(outline(Side::Left));
    case ShownSides::Right: return terrain_->setOutline(outline(Side::Right));
    case ShownSides::Both: break;
    }
    terrain_->setOutline(outline(Side::Right), outline(Side::Left));
}

void TerrainPage::showVerdict(const TerrainViewState& viewState)
{
    if (!viewState.verdict)
        return verdict_->setNothing(!viewState.live ? viewState.whyNoEstimate
                                    : flippersMove(viewState)
                                        ? tr("The flippers still move")
                                        : tr("The estimate is being computed"));
    QString probe;
    const ProbeProposal* const proposal = viewState.proposal    ? viewState.proposal
                                        : showsWorth(viewState) ? &*viewState.bestProbe
                                                                : nullptr;
    if (proposal && proposal->worth && proposal->stepLimit == verdict_->limit())
        probe = probeGainText(*proposal);
    else if (!proposal && isOpen(viewState))
        probe = viewState.whyNoBestProbe;
    verdict_->setVerdict(*viewState.verdict, probe);
    terrain_->setFullSide(decidingSide(*viewState.verdict));
}

/// Offers a probe whenever a verdict is CANNOT TELL: bin, expected gain and button.
void TerrainPage::showProbeToAsk(const TerrainViewState& viewState)
{
    if (!isOpen(viewState)) return atem_->setProbeToAsk(std::nullopt);
    const auto& best = viewState.bestProbe;
    atem_->setProbeToAsk(
        best ? ProbeToAsk{.place = ProbePlace{best->bin, best->side}, .text = probeGainText(*best)}
             : ProbeToAsk{.place = {}, .text = viewState.whyNoBestProbe});
}

void TerrainPage::showProbe(const TerrainViewState& viewState)
{
    const bool asking = viewState.proposal && viewState.state.phase == AtemPhase::ProposingProbe;
    // Proposals and motion are shown in every layout.
    const bool needed = asking || viewState.probingPlace;
    const bool tells = isOpen(viewState) && isAtRest(viewState);
    probe_->setVisible(((layout_->layout() == Layout::Probe || tells) && !isTight()) || needed);
    layout_->setProposes(needed);
    // With a large font the proposal takes the room; the robot stands still meanwhile.
    readout_->setVisible(!asking || layout_->fontScale() <= 120 || isTight());
    terrain_->setArmTip(viewState.past
                            ? std::nullopt
                            : armTipOf(viewState, asking && !firstMissing(viewState.probing)));
    if (asking) {
        ProbeProposal proposal = *viewState.proposal;
        if (viewState.verdict && proposal.stepLimit == verdict_->limit())
            proposal.answer = viewState.verdict->both;
        probe_->setProposal(proposal);
        probe_->setPreconditions(viewState.probing);
        probe_->setTimeLeft(viewState.time ? viewState.time->seconds : 0.0);
    } else if (viewState.probingPlace) {
        probe_->setProbing(*viewState.probingPlace, viewState.secondsInPhase,
                           viewState.probeSeconds);
    } else if (isAtRest(viewState)) {
        probe_->setWorth(*viewState.bestProbe, whyNoProbe(viewState));
    } else {
        probe_->setNothing(whyNoProbe(viewState));
    }
}

}  // namespace terratact
