// Feel forward: the exploration repeats itself while the operator holds a control.
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/exploration.h"
#include "core/atem/feel_forward.h"

namespace terratact {
namespace {

/// Returns true if the loop ended as the operator wanted.
bool isWanted(LoopEnd end)
{
    return end == LoopEnd::LetGo || end == LoopEnd::Aborted || end == LoopEnd::ProbeProposed;
}

/// Returns true if the loop ended because the next advance was forbidden.
bool asksOperator(LoopEnd end)
{
    switch (end) {
    case LoopEnd::None:
    case LoopEnd::LetGo:
    case LoopEnd::Aborted:
    case LoopEnd::Stop:
    case LoopEnd::Fault:
    case LoopEnd::ProbeProposed: return false;
    case LoopEnd::Stale:
    case LoopEnd::NoVerdict:
    case LoopEnd::SensorFault:
    case LoopEnd::Contradiction:
    case LoopEnd::Withheld:
    case LoopEnd::Blocked:
    case LoopEnd::NotFelt:
    case LoopEnd::ShortReach:
    case LoopEnd::Bounded:
    case LoopEnd::Undecided:
    case LoopEnd::ShortHorizon:
    case LoopEnd::Attitude:
    case LoopEnd::NoOdometry: return true;
    }
    return true;
}

}  // namespace

void Exploration::feelForward()
{
    if (whyNotFeelingForward()) return;
    emit decided("feel forward", {});
    held_ = true;
    pending_.loopRequested = true;
    asked_.reset();
    driving_ = false;
    driveWanted_.reset();
}

void Exploration::letGo()
{
    if (!std::exchange(held_, false)) return;
    pending_.loopRequested = false;
    if (!state_.loops) return;
    emit decided("let go", {});
    // The next tick ends the exploration, too. The halt does not wait for it.
    if (!estimating()) command(HaltCommand{});
}

QList<Precondition> Exploration::toFeelForward() const
{
    if (following()) return {Preconditions::arming(following_->why())};
    QList<Precondition> list = preconditions();
    list << Preconditions::notExploring(exploring(state_.phase));
    return list << Preconditions::odometry(latest_ && latest_->sample.measurement.travelled);
}

std::optional<Message> Exploration::whyNotFeelingForward() const
{
    for (const Precondition& need : toFeelForward())
        if (need.level == Precondition::Level::Missing
            || need.level == Precondition::Level::Doubtful)
            return need.text;
    return std::nullopt;
}

FeltAhead Exploration::feltAhead() const
{
    FeltAhead ahead{.verdict = estimation_.verdict(), .telemetryFresh = telemetryFresh_};
    if (!latest_) return ahead;
    const Measurement& m = latest_->sample.measurement;
    ahead.odometry = m.travelled.has_value();
    ahead.attitude = attitudeOf(m, robot_, options_.attitude).worst();
    return ahead;
}

ProbeOffer Exploration::loopOffer() const
{
    // Every probe takes much longer than an advance, so only a probe that would decide is proposed.
    if (whyNotAdvancing(feltAhead()) == LoopEnd::None) return {};
    return probes_.offer(options_.probes == ProbePolicy::Variance ? ProbePolicy::Question
                                                                  : options_.probes);
}

void Exploration::pollLoop(AtemInput& in)
{
    in.held = held_;
    in.telemetryFresh = telemetryFresh_;
    if (state_.phase == AtemPhase::Presenting && (state_.loops || in.loopRequested))
        in.forbids = whyNotAdvancing(feltAhead());
    if (state_.phase == AtemPhase::Advancing) pollAdvance(in);
}

void Exploration::pollAdvance(AtemInput& in)
{
    in.tilted = feltAhead().attitude != AttitudeLevel::Level;
    if (!advance_ || !answered()) return;
    const Measurement& m = latest_->sample.measurement;
    in.advanceRefused = m.refusal != Refusal::None;
    switch (advance_->poll(m)) {
    case AdvanceWatch::Result::Running: break;
    case AdvanceWatch::Result::Advanced: in.advanced = true; break;
    case AdvanceWatch::Result::NotMoved: in.notMoved = true; break;
    case AdvanceWatch::Result::RanOn: in.ranOn = true; break;
    case AdvanceWatch::Result::NoOdometry: in.noOdometry = true; break;
    }
}

void Exploration::sendAdvance()
{
    if (state_.phase != AtemPhase::Advancing || advance_) return;
    if (isRobotStillExploring(state_.since)) return;
    if (ask(AdvanceCommand{.distance = kAdvance}))
        advance_.emplace(latest_->sample.measurement, kAdvance);
}

void Exploration::beginAdvance()
{
    advance_.reset();
    emit happened(Message(TR_NOOP("terratact::Exploration",
                                  "advancing %1 m: CLEAR for %2 m ahead of the tracks"),
                          fixed(kAdvance, 1), fixed(clearWay(*estimation_.verdict()), 2)),
                  EventSeverity::Note);
}

void Exploration::endAdvance()
{
    if (advance_) pace_.way += advance_->way();
    advance_.reset();
}

void Exploration::showLoop(const AtemState& before)
{
    if (before.phase == AtemPhase::Advancing && state_.phase != AtemPhase::Advancing) endAdvance();
    if (state_.loops && !before.loops) {
        pace_ = {.began = now_};
        emit happened(
            TR_NOOP("terratact::Exploration", "feeling forward while the control is held"),
            EventSeverity::Note);
    }
    if (state_.loops || !before.loops) return;
    pace_.ended = now_;
    emit happened(Message(TR_NOOP("terratact::Exploration",
                                  "feel forward has ended after %1 m, %2 m/min: %3"),
                          fixed(pace_.way, 2), fixed(pace_.metresPerMinute(now_), 1),
                          describe(state_.loopEnd)),
                  isWanted(state_.loopEnd) ? EventSeverity::Note : EventSeverity::Warning);
}

LoopPace Exploration::pace() const
{
    LoopPace pace = pace_;
    if (advance_) pace.way += advance_->way();
    return pace;
}

Message Exploration::loopText() const
{
    if (state_.loops)
        return Message(TR_NOOP("terratact::Exploration", "feel forward: %1 · %2 m · %3 m/min"),
                       describe(state_.phase), fixed(pace().way, 2),
                       fixed(pace().metresPerMinute(now_), 1));
    const bool asks = state_.phase == AtemPhase::Presenting || state_.phase == AtemPhase::Idle;
    if (!asks || !asksOperator(state_.loopEnd)) return {};
    return Message(TR_NOOP("terratact::Exploration", "feel forward has ended after %1 m: %2"),
                   fixed(pace_.way, 2), describe(state_.loopEnd));
}

}  // namespace terratact
