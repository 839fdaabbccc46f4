#include "app/mission/passive_exploration.h"

#include <algorithm>
#include <utility>

namespace terratact {

PassiveExploration::PassiveExploration(Message why, Estimation& estimation,
                                       const AtemLimits& limits)
    : why_(std::move(why)), estimation_(estimation), limits_(limits)
{
}

void PassiveExploration::poll(FollowInput& in, const Received& latest) const
{
    const Measurement& m = latest.sample.measurement;
    const auto& readings = estimation_.readings();
    const bool captured = latest.press && latest.press->count == captured_;
    in.activity = m.activity;
    in.newPress = latest.press && !captured && !estimation_.model().name.isEmpty();
    in.newReading = captured && estimation_.scene() && m.arm
                 && std::ranges::find(readings, *m.arm) == readings.end();
    in.poseChanged = estimation_.hasMoved();
}

void PassiveExploration::tick(AtemState& state, FollowInput in, const Received& latest)
{
    poll(in, latest);
    if (in.aborted && estimation_.estimate()) estimation_.takeBack();
    if (in.linkLost) {  // the robot may have moved meanwhile
        captured_ = 0;
        lostAt_ = latest.count;
    }
    const AtemState before = state;
    state = nextFollowed(state, in, limits_);
    if (state != before) enter(state, latest);
    if (estimation_.hasLeft() && estimation_.estimate()) estimation_.forget(whyMoved());
}

void PassiveExploration::enter(const AtemState& state, const Received& latest)
{
    switch (state.phase) {
    case AtemPhase::Pressing:
        estimation_.forget(
            TR_NOOP("terratact::PassiveExploration", "Following: the front flippers press down"));
        break;
    case AtemPhase::Estimating:
        estimation_.forget(TR_NOOP("terratact::PassiveExploration", "Estimating …"));
        emit happened(TR_NOOP("terratact::PassiveExploration",
                              "following: the robot has pressed its flippers down"),
                      EventSeverity::Note);
        captured_ = latest.press->count;
        estimation_.begin(latest, lostAt_);
        break;
    case AtemPhase::Probing:
        emit happened(TR_NOOP("terratact::PassiveExploration", "following: the arm is probing"),
                      EventSeverity::Note);
        break;
    case AtemPhase::EstimatingAgain:
        estimation_.addArmReading(*latest.sample.measurement.arm);
        break;
    case AtemPhase::Stopped:
        emit happened(TR_NOOP("terratact::PassiveExploration", "following: the robot is stopped"),
                      EventSeverity::Bad);
        estimation_.cancel();
        if (!estimation_.estimate())
            estimation_.forget(
                TR_NOOP("terratact::PassiveExploration", "No estimate: the robot is stopped"));
        break;
    case AtemPhase::Failed: fail(state.failure); break;
    case AtemPhase::Idle:
        estimation_.cancel();
        estimation_.forget(estimation_.hasMoved() ? whyMoved() : Message());
        break;
    case AtemPhase::Presenting:
    case AtemPhase::Halting:
    case AtemPhase::ProposingProbe:
    case AtemPhase::Advancing: break;
    }
}

void PassiveExploration::fail(AtemFailure failure)
{
    const SourceText why = describe(failure);
    emit stateChanged(
        Message(TR_NOOP("terratact::PassiveExploration", "following: no estimate: %1"), why),
        EventSeverity::Bad);
    estimation_.cancel();
    estimation_.forget(Message(TR_NOOP("terratact::PassiveExploration", "No estimate: %1"), why));
}

Message PassiveExploration::whyMoved()
{
    return TR_NOOP("terratact::PassiveExploration",
                   "The robot has moved: the next press gives the next estimate");
}

}  // namespace terratact
