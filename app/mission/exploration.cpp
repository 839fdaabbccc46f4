#include "app/mission/exploration.h"

#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/text/bus_text.h"
#include "app/mission/text/place_text.h"

namespace terratact {
namespace {

constexpr double kEndsWithin = 1.0;   // [s] a robot needs to end an exploration
constexpr double kRepeatBegin = 0.3;  // [s]

}  // namespace

Exploration::Exploration(MeasurementSource& source, RobotModel robot, EstimatorWorker& worker,
                         const Options& options, CanSource* link)
    : source_(source), link_(link), robot_(std::move(robot)), options_(options),
      estimation_(worker, robot_, options_),
      probes_(estimation_, robot_, options_.probeSeconds, options_.probes)
{
    if (const auto why = whyFollowing(link)) {
        following_ = std::make_unique<PassiveExploration>(*why, estimation_, options_.limits);
        connect(following_.get(), &PassiveExploration::happened, this, &Exploration::happened);
        connect(following_.get(), &PassiveExploration::stateChanged, this,
                &Exploration::stateChanged);
    }
    state_.followed = following();
    connect(&estimation_, &Estimation::happened, this, &Exploration::happened);
    connect(&estimation_, &Estimation::offered, this, &Exploration::addAdvice);
    connect(&estimation_, &Estimation::advised, this, &Exploration::askAnew);
    connect(&estimation_, &Estimation::failed, this, [this] { pending_.estimateFailed = true; });
    connect(&estimation_, &Estimation::modelChanged, this, [this] {
        // The displayed estimate belongs to the previous model.
        if (estimation_.estimate() && !exploring(state_.phase)) pending_.aborted = true;
    });
}

void Exploration::addAdvice()
{
    ProbeOffer offer = state_.loops ? loopOffer() : probes_.offer();
    if (const auto asked = std::exchange(asked_, std::nullopt)) offer = {.place = asked};
    if (estimation_.wasPitchSuspected()) offer.place.reset();
    pending_.estimateReady = true;
    pending_.probeWanted = offer.place.has_value();
    offered_ = pending_.probeWanted;
    probes_.withdraw();
    if (offer.place && !following()) probes_.propose(*offer.place);
}

void Exploration::askAnew()
{
    if (!probes_.stands()) return;  // the same text with other data would be another proposal
    probes_.propose({probes_.current()->bin, probes_.current()->side});
    if (state_.phase == AtemPhase::ProposingProbe) emit proposed();
}

bool Exploration::reportsExploring() const
{
    return bus_ && bus_->link.robot && bus_->link.robot->exploring;
}

bool Exploration::isRobotStillExploring(double endedAt) const
{
    // After an abort the robot accepts a drive or an advance only once its next status reports the end.
    return reportsExploring() && now_ - endedAt < kEndsWithin;
}

void Exploration::beginOn()
{
    if (state_.phase != AtemPhase::Halting || hasBegun()) return;
    // Frames can be lost, and a begin that waits for the robot's challenge can be dropped.
    const bool isDue = !askedToBegin_ || (bus_ && now_ - *askedToBegin_ >= kRepeatBegin);
    const bool before = reportsExploring();
    if (!isDue && (before || beginWasAsked_)) return;
    askedToBegin_ = now_;
    if (before) return static_cast<void>(unsent(AbortAtemCommand{}));
    const bool first = !std::exchange(beginWasAsked_, true);
    notSent_ =
        (first ? command(BeginAtemCommand{}) : unsent(BeginAtemCommand{})).value_or(Message());
}

bool Exploration::hasBegun() const
{
    const bool tells = bus_ && bus_->link.robot;  // else the press is its answer
    return beginWasAsked_ && (!tells || reportsExploring());
}

Message Exploration::whyNotBegun() const
{
    if (!beginWasAsked_)
        return TR_NOOP("terratact::Exploration", "it still reports the exploration before");
    if (!notSent_.empty()) return notSent_;
    const auto robot = bus_ ? bus_->link.robot : std::nullopt;
    const bool refused =
        robot && robot->lastCommand == FrameKind::BeginAtem && robot->refusal != Refusal::None;
    return refused ? Message(describe(robot->refusal)) : Message();
}

void Exploration::driveOn()
{
    if (!driveWanted_ || isRobotStillExploring(driveBegan_)) return;
    if (whyNotDriving()) return driveWanted_.reset();  // driving is no longer allowed
    command(*std::exchange(driveWanted_, std::nullopt));
}

std::optional<Message> Exploration::unsent(const Command& command)
{
    commandedAt_ = latest_ ? latest_->count : 0;
    const Status sent = source_.send(command);
    return sent ? std::nullopt : std::optional(troubleOf(link_, sent.error().message));
}

std::optional<Message> Exploration::command(const Command& command)
{
    std::optional<Message> why = unsent(command);
    if (why)
        emit happened(Message(TR_NOOP("terratact::Exploration", "command not sent: %1"), *why),
                      EventSeverity::Bad);
    return why;
}

bool Exploration::ask(const Command& wanted)
{
    const std::optional<Message> why = command(wanted);
    pending_.notSent = why.has_value();
    if (why) notSent_ = *why;
    return !why;
}

bool Exploration::armed() const
{
    return !link_ || (bus_ && bus_->link.arming.phase == ArmingPhase::Armed);
}

bool Exploration::answered() const
{
    // The next sample may have been measured before the command arrived; the one after it was not.
    return latest_ && latest_->count >= commandedAt_ + 2;
}

bool Exploration::hasPressed() const
{
    // A press that began after the command is its answer at the first sample that shows it.
    return latest_->sample.measurement.activity == RobotActivity::Pressed
        && (answered() || (latest_->press && latest_->press->count > commandedAt_));
}

void Exploration::poll(AtemInput& in)
{
    in.linkAlive = linkAlive_;
    repeatStop(in);  // also without telemetry
    pollLoop(in);
    if (!latest_) return;
    const Measurement& m = latest_->sample.measurement;
    in.poseChanged = estimation_.hasMoved();
    if (state_.phase == AtemPhase::Pressing) in.pressed = hasPressed();
    const bool stands = m.activity == RobotActivity::Halted || m.activity == RobotActivity::Pressed;
    in.unbegun = stands && !hasBegun();
    if (!answered()) return;
    const bool refused = m.refusal != Refusal::None;
    if (exploring(state_.phase)) refusal_ = m.refusal;
    switch (state_.phase) {
    case AtemPhase::Halting: in.halted = stands && hasBegun(); break;
    case AtemPhase::Pressing:
        in.pressRefused = refused || m.activity == RobotActivity::Halted;
        break;
    case AtemPhase::Probing:
        sawProbing_ = sawProbing_ || m.activity == RobotActivity::Probing;
        in.probeRefused = refused || m.activity == RobotActivity::Halted;
        in.probeDone = m.activity == RobotActivity::Pressed && m.arm && m.arm->bin == probing_.bin
                    && m.arm->side == probing_.side && (sawProbing_ || m.arm != armBefore_);
        break;
    case AtemPhase::Idle:
    case AtemPhase::Estimating:
    case AtemPhase::ProposingProbe:
    case AtemPhase::EstimatingAgain:
    case AtemPhase::Presenting:
    case AtemPhase::Stopped:
    case AtemPhase::Failed:
    case AtemPhase::Advancing: break;
    }
}

void Exploration::tick(const RobotMoment& moment)
{
    now_ = moment.now;
    latest_ = moment.latest;
    bus_ = moment.bus;
    const auto isFreshWithin = [this](double seconds) {
        return latest_ && now_ - secondsOf(latest_->arrived) <= seconds;
    };
    linkAlive_ = isFreshWithin(options_.linkLostAfter);
    ended_ = following() && bus_ && bus_->ended;
    telemetryFresh_ = isFreshWithin(options_.staleAfter);
    estimation_.poll(latest_, telemetryFresh_);
    if (following())
        follow();
    else
        advance();
    preview();
}

void Exploration::follow()
{
    if (!latest_) return;
    const AtemInput in = std::exchange(pending_, AtemInput{});
    following_->tick(state_,
                     {.now = now_,
                      .linkLost = !linkAlive_ && !ended_,
                      .aborted = in.aborted,
                      .estimateReady = in.estimateReady,
                      .estimateFailed = in.estimateFailed},
                     *latest_);
}

void Exploration::advance()
{
    AtemInput in = std::exchange(pending_, AtemInput{});
    in.now = now_;
    in.armed = armed();
    if (in.approved) {
        in.approvalAge = now_ - approvedAt_;
        in.grounds = probes_.grounds();
    }
    poll(in);
    endOverrides();
    if (in.aborted && !exploring(state_.phase) && estimation_.estimate()) {
        estimation_.takeBack();
        forget(TR_NOOP("terratact::Exploration", "No estimate: explore the terrain (A)"));
    }
    if (estimation_.hasLeft() && estimation_.estimate())
        forget(TR_NOOP("terratact::Exploration", "The robot has moved: explore again (A)"));

    const AtemState before = state_;
    state_ = nextState(state_, in, options_.limits);
    if (state_.phase != before.phase) enter(before);
    showLoop(before);
    beginOn();
    sendAdvance();
    driveOn();
    watchDrive();
}

/// Reports a drive without motion. It happens at the end of the simulated ground, and at ground so steep that the
/// raised flippers touch it. Nothing else reports it.
void Exploration::watchDrive()
{
    if (!latest_ || !linkAlive_ || !driveWatch_.poll(latest_->sample.measurement, now_)) return;
    if (!options_.groundFile)
        emit happened(TR_NOOP("terratact::Exploration",
                              "the robot reports driving, but its tracks do not move"),
                      EventSeverity::Bad);
    else if (options_.groundFile->empty())
        emit happened(TR_NOOP("terratact::Exploration",
                              "the robot drives no further: the built-in ground ends here, or is "
                              "too steep. Drive back, or start with another --terrain"),
                      EventSeverity::Bad);
    else
        emit happened(
            Message(TR_NOOP("terratact::Exploration",
                            "the robot drives no further: the ground of the file %1 ends here, or "
                            "is too steep. Drive back, or start with another --terrain"),
                    verbatim(format::fileName(QString::fromStdString(*options_.groundFile)))),
            EventSeverity::Bad);
}

void Exploration::preview()
{
    if (state_.phase == AtemPhase::Pressing) return estimation_.preview(*latest_);
    if (state_.phase == AtemPhase::Estimating)
        return;  // the preview stays until the estimate is ready
    estimation_.endPreview();
    if (linkAlive_ && armed() && !exploring(state_.phase)) estimation_.prepare();
}

void Exploration::enter(const AtemState& before)
{
    // This includes a probe proposed in the tick that ended the exploration.
    if (state_.phase != AtemPhase::ProposingProbe && state_.phase != AtemPhase::Probing)
        probes_.withdraw();
    if (!exploring(state_.phase)) asked_.reset();
    switch (state_.phase) {
    case AtemPhase::Halting:
        forget(TR_NOOP("terratact::Exploration", "Exploring: the robot halts"));
        if (!before.loops)
            emit happened(TR_NOOP("terratact::Exploration", "exploration requested"),
                          EventSeverity::Note);
        askedToBegin_.reset();
        beginWasAsked_ = false;
        break;
    case AtemPhase::Pressing:
        forget(TR_NOOP("terratact::Exploration", "Exploring: the front flippers press down"));
        ask(PressCommand{.torque = options_.pressTorque});
        break;
    case AtemPhase::Estimating:
        forget(TR_NOOP("terratact::Exploration", "Estimating …"));
        pressTook_ = state_.since - before.since;
        estimation_.begin(*latest_, commandedAt_);
        break;
    case AtemPhase::ProposingProbe:
        emit proposed();
        emit happened(Message(TR_NOOP("terratact::Exploration", "probe proposed %1"),
                              placeMessage({probes_.current()->bin, probes_.current()->side})),
                      EventSeverity::Note);
        break;
    case AtemPhase::Probing: probe(); break;
    case AtemPhase::EstimatingAgain:
        estimation_.addArmReading(*latest_->sample.measurement.arm);
        break;
    case AtemPhase::Presenting: present(before.phase == AtemPhase::ProposingProbe); break;
    case AtemPhase::Idle: end(exploring(before.phase)); break;
    case AtemPhase::Stopped:
        estimation_.cancel();
        emit happened(TR_NOOP("terratact::Exploration", "STOP"), EventSeverity::Bad);
        if (!estimation_.estimate())
            forget(TR_NOOP("terratact::Exploration", "No estimate: STOP is latched"));
        break;
    case AtemPhase::Failed: fail(); break;
    case AtemPhase::Advancing: beginAdvance(); break;
    }
}

void Exploration::probe()
{
    probing_ = {.bin = probes_.current()->bin, .side = probes_.current()->side};
    probes_.withdraw();
    emit happened(Message(TR_NOOP("terratact::Exploration", "probe %1 approved"),
                          placeMessage({probing_.bin, probing_.side})),
                  EventSeverity::Note);
    sawProbing_ = false;
    armBefore_ = latest_->sample.measurement.arm;
    if (link_) link_->approve(probing_);
    ask(probing_);
}

void Exploration::present(bool unprobed)
{
    if (unprobed && state_.approvalExpired)
        emit happened(TR_NOOP("terratact::Exploration", "no answer in time: refused"),
                      EventSeverity::Warning);
    else if (unprobed)
        emit happened(TR_NOOP("terratact::Exploration", "probe refused"), EventSeverity::Note);
    probes_.withdraw();
    command(AbortAtemCommand{});
}

void Exploration::end(bool aborted)
{
    releasing_ = false;
    if (!aborted) return;
    estimation_.cancel();
    command(AbortAtemCommand{});
    emit happened(TR_NOOP("terratact::Exploration", "exploration ended by the operator"),
                  EventSeverity::Warning);
    if (!estimation_.estimate())
        forget(TR_NOOP("terratact::Exploration", "No estimate: explore the terrain (A)"));
}

void Exploration::fail()
{
    disarmedBy_ = bus_ ? bus_->link.arming.cause : DisarmCause::None;
    if (state_.failure == AtemFailure::BeginTimeout) notSent_ = whyNotBegun();
    const Message why = failureText();
    estimation_.cancel();
    if (linkAlive_) command(AbortAtemCommand{});
    emit stateChanged(Message(TR_NOOP("terratact::Exploration", "exploration failed: %1"), why),
                      EventSeverity::Bad);
    if (!estimation_.estimate())
        forget(Message(TR_NOOP("terratact::Exploration", "No estimate: %1"), why));
}

void Exploration::forget(const Message& why)
{
    estimation_.forget(why);
    probes_.withdraw();
}

std::optional<PhaseTime> Exploration::time() const
{
    return phaseTime(state_, now_, options_.limits,
                     {.press = pressTook_, .probe = options_.probeSeconds});
}

Message Exploration::stateText() const
{
    if (state_.phase == AtemPhase::Failed) return failureText();
    if (Message loop = loopText(); !loop.empty()) return loop;
    switch (const StopViewState stop = stopViewState(); stop.state) {
    case StopViewState::State::Sent:
        return TR_NOOP("terratact::Exploration", "STOP sent, not confirmed by the robot");
    case StopViewState::State::NotSent:
        return Message(TR_NOOP("terratact::Exploration", "STOP not sent: %1"), stopTrouble_);
    case StopViewState::State::Ready:
    case StopViewState::State::Confirmed:
    case StopViewState::State::Elsewhere:
    case StopViewState::State::NoEffect: return {};
    }
    return {};
}

Message Exploration::failureText() const
{
    const SourceText what = describe(state_.failure);
    if (state_.failure == AtemFailure::Disarmed && disarmedBy_ != DisarmCause::None)
        return Message::joined(what, describe(disarmedBy_));
    const bool isOfCommand =
        state_.failure == AtemFailure::NotSent || state_.failure == AtemFailure::BeginTimeout;
    if (isOfCommand) return notSent_.empty() ? Message(what) : Message::joined(what, notSent_);
    const bool refused = state_.failure == AtemFailure::PressRefused
                      || state_.failure == AtemFailure::ProbeRefused
                      || state_.failure == AtemFailure::AdvanceRefused;
    if (!refused || refusal_ == Refusal::None) return what;
    return Message::joined(what, describe(refusal_));
}

std::optional<ProbePlace> Exploration::probingPlace() const
{
    if (state_.phase != AtemPhase::Probing || following()) return std::nullopt;
    return ProbePlace{probing_.bin, probing_.side};
}

void Exploration::endOverrides()
{
    if (!latest_) return;
    const Measurement& m = latest_->sample.measurement;
    for (const Message& reason : ground_.endOverrides(m, options_.settings))
        emit happened(
            Message(TR_NOOP("terratact::Exploration", "the override has ended: %1"), reason),
            EventSeverity::Warning);
}

}  // namespace terratact
