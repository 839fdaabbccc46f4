#include "app/mission/exploration.h"

#include <algorithm>
#include <utility>

#include "app/mission/bus_text.h"
#include "display/format.h"

namespace terratact {
namespace {

constexpr double kRepeatStop = 0.2;  // [s]
constexpr double kReleaseFor = 5.0;  // [s] a release of STOP is retried
constexpr double kEndsWithin = 1.0;  // [s] a robot needs to end an exploration

}  // namespace

Exploration::Exploration(MeasurementSource& source, RobotModel robot, EstimatorWorker& worker,
                         const Options& options, CanSource* link)
    : source_(source), link_(link), robot_(std::move(robot)), options_(options),
      estimation_(worker, robot_, options_),
      probes_(estimation_, robot_, options_.probeSeconds, options_.probes)
{
    if (const QString why = whyFollowing(link); !why.isEmpty()) {
        following_ = std::make_unique<PassiveExploration>(why, estimation_, options_.limits);
        connect(following_.get(), &PassiveExploration::happened, this, &Exploration::happened);
    }
    state_.followed = following();
    connect(&estimation_, &Estimation::happened, this, &Exploration::happened);
    connect(&estimation_, &Estimation::offered, this, &Exploration::takeAdvice);
    connect(&estimation_, &Estimation::advised, this, &Exploration::askAnew);
    connect(&estimation_, &Estimation::failed, this, [this] { pending_.estimateFailed = true; });
    connect(&estimation_, &Estimation::modelChanged, this, [this] {
        // The displayed estimate belongs to the previous model.
        if (estimation_.estimate() && !exploring(state_.phase)) pending_.aborted = true;
    });
}

void Exploration::takeAdvice()
{
    ProbeOffer offer = probes_.offer();
    if (const auto asked = std::exchange(askedBin_, std::nullopt)) offer = {.bin = asked};
    pending_.estimateReady = true;
    pending_.probeWanted = offer.bin.has_value();
    offered_ = pending_.probeWanted;
    probes_.withdraw();
    if (offer.bin && !following()) probes_.propose(*offer.bin);
}

void Exploration::askAnew()
{
    if (!probes_.stands()) return;  // the same text with other data would be another proposal
    probes_.propose(probes_.current()->bin);
    if (state_.phase == AtemPhase::ProposingProbe) emit proposed();
}

QString Exploration::whyNoEstimate() const
{
    if (QString why = estimation_.whyNone(); !why.isEmpty()) return why;
    const ModelInUse& model = estimation_.model();
    if (!linkAlive_ && !ended_) return tr("No estimate yet: no telemetry from the robot");
    if (!model.trouble.isEmpty()) return tr("No estimate: there is no model");
    if (model.name.isEmpty()) return tr("No estimate yet: the model is being loaded");
    if (following()) return tr("No estimate yet: it comes when the robot presses its flippers");
    if (!armed()) return tr("No estimate yet: press M, then hold M to arm; then explore (A)");
    return tr("No estimate yet: explore the terrain (A)");
}

QString Exploration::whyNotOffered() const
{
    if (!estimation_.estimate() || offered_) return {};
    const ProbeOffer now = probes_.offer();  // limit, policy and telemetry may have changed
    if (now.bin) return tr("Not offered when the estimate came: explore again to be asked");
    return wordsOf(now.why);
}

QString Exploration::wordsOf(NoProbe why) const
{
    switch (why) {
    case NoProbe::None: break;
    case NoProbe::Certain:
        return tr("Not offered: no bin in reach is less certain than ± %1 m")
            .arg(format::number(estimation_.estimate()->settings.probeAbove, 2));
    case NoProbe::Decided:
        return tr("Not offered, as the settings have it: %1 stands without the arm")
            .arg(format::sentence(name(estimation_.verdict()->stepVerdict)));
    case NoProbe::NoGain:
        return tr("Not offered, as the settings have it: no bin in reach tells about the step");
    }
    return {};
}

void Exploration::request()
{
    if (following() || armIsOut()) return;
    askedBin_.reset();
    explore();
}

void Exploration::explore()
{
    emit decided("explore", {});
    pending_.requested = true;
    driving_ = false;  // the exploration itself sends the halt
    driveWanted_.reset();
}

bool Exploration::inReach(int bin) const
{
    return bin >= 0 && bin < kBins && robot_.armSd > 0.0 && robot_.armReaches(bin);
}

QString Exploration::whyNotAsking(int bin) const
{
    if (following()) return following_->why();
    if (!inReach(bin)) return tr("the arm does not reach bin %1").arg(format::binName(bin));
    if (state_.phase == AtemPhase::ProposingProbe)
        return probes_.stands() ? QString() : Preconditions::stands(false).text;
    if (exploring(state_.phase)) return tr("an exploration is running");
    for (const Precondition& need : preconditions())
        if (need.level == Precondition::Level::Missing
            || need.level == Precondition::Level::Doubtful)
            return need.text;
    return {};
}

void Exploration::askProbe(int bin)
{
    if (const QString why = whyNotAsking(bin); !why.isEmpty())
        return void(
            emit happened(tr("no probe is asked for: %1").arg(why), EventSeverity::Warning));
    if (state_.phase == AtemPhase::ProposingProbe) return choose(probes_.current()->id, bin);
    emit decided("choose", format::binName(bin));
    emit happened(tr("a probe at %1 is wanted: the robot presses anew, then it is asked")
                      .arg(format::binName(bin)),
                  EventSeverity::Note);
    askedBin_ = bin;
    explore();
}

void Exploration::forgetResult()
{
    if (exploring(state_.phase)) return;
    const bool stood = estimation_.estimate().has_value();
    emit decided("forget", {});
    estimation_.setAside(tr("No estimate: explore the terrain (A)"));
    probes_.withdraw();
    const bool ends = state_.phase == AtemPhase::Presenting || state_.phase == AtemPhase::Failed;
    if (ends || following()) pending_.aborted = true;
    if (stood)
        emit happened(tr("the estimate is off the screen: Ctrl+Z brings it back"),
                      EventSeverity::Note);
}

void Exploration::restoreResult()
{
    if (!exploring(state_.phase) && estimation_.restore()) {
        pending_.aborted = false;
        emit decided("restore", {});
        emit happened(tr("the estimate is back"), EventSeverity::Note);
    } else {
        emit happened(tr("no estimate can be brought back"), EventSeverity::Note);
    }
}

void Exploration::abort()
{
    emit decided("abort", {});
    pending_.aborted = true;
}

void Exploration::approve(quint64 proposal)
{
    if (!probes_.isCurrent(proposal)) return;
    emit decided("approve", format::binName(probes_.current()->bin));
    pending_.approved = true;
    pending_.approvedFor = probes_.proposedOn();
    approvedAt_ = now_;
}

void Exploration::refuse(quint64 proposal)
{
    if (!probes_.isCurrent(proposal)) return;
    emit decided("refuse", format::binName(probes_.current()->bin));
    pending_.refused = true;
}

void Exploration::choose(quint64 proposal, int bin)
{
    if (!probes_.isCurrent(proposal) || !probes_.stands() || !inReach(bin)) return;
    emit decided("choose", format::binName(bin));
    probes_.propose(bin);
    emit proposed();
    emit happened(tr("probe asked for at %1 instead").arg(format::binName(bin)),
                  EventSeverity::Note);
}

void Exploration::setStepLimit(double metres)
{
    if (metres == options_.stepLimit) return;
    options_.stepLimit = metres;
    estimation_.adviseAnew();
}

void Exploration::setSecondMethod(std::optional<Method> method)
{
    emit decided("second method", method ? format::text(name(*method)) : QStringLiteral("none"));
    estimation_.setSecondMethod(method);
}

void Exploration::drive(int direction)
{
    if (!whyNotDriving().isEmpty()) return;
    driving_ = true;
    driveBegan_ = now_;
    driveWanted_ = DriveCommand{.speed = direction * options_.driveSpeed};
    emit decided("drive", direction > 0 ? QStringLiteral("forward") : QStringLiteral("back"));
    driveOn();
}

void Exploration::driveOn()
{
    // After an abort the robot accepts a drive only once its next status reports the end of the exploration.
    if (!driveWanted_) return;
    const auto robot = bus_ ? bus_->link.robot : std::nullopt;
    if (robot && robot->exploring && now_ - driveBegan_ < kEndsWithin) return;
    if (!whyNotDriving().isEmpty()) return driveWanted_.reset();  // driving is no longer allowed
    command(*std::exchange(driveWanted_, std::nullopt));
}

void Exploration::halt()
{
    if (!std::exchange(driving_, false)) return;
    driveWanted_.reset();
    emit decided("halt", {});
    command(HaltCommand{});
}

void Exploration::stop()
{
    stopFrom({});
}

void Exploration::stopFrom(const QString& where)
{
    if (following()) {
        emit stoppedNothing(following_->why());
        return;  // nothing is stopped, so the display must not say so
    }
    emit decided("stop", where);
    if (stopViewState().state != StopViewState::State::Sent
        && stopViewState().state != StopViewState::State::NotSent)
        stopBegan_ = now_;
    // A repeated press keeps an existing confirmation.
    stopConfirmed_ = stopConfirmed_ && linkAlive_ && !releasing_;
    sendStop();
    pending_.stop = true;
    releasing_ = false;
    driving_ = false;
    driveWanted_.reset();
}

void Exploration::sendStop()
{
    stopSent_ = now_;
    commandedAt_ = latest_ ? latest_->count : 0;
    const Status sent = source_.send(StopCommand{});
    const QString trouble = sent ? QString() : troubleWords(link_, sent.error().text);
    if (!trouble.isEmpty() && trouble != stopTrouble_)
        emit happened(tr("STOP not sent: %1").arg(trouble), EventSeverity::Bad);
    stopTrouble_ = trouble;
}

void Exploration::confirmStop(bool latched)
{
    if (!linkAlive_ || latched == stopConfirmed_ || (releasing_ && !latched)) return;
    stopConfirmed_ = latched;
    if (latched)
        emit happened(tr("the robot says that it is stopped"), EventSeverity::Note);
    else
        stopBegan_ = now_;  // the request starts again
}

StopViewState Exploration::stopViewState() const
{
    using State = StopViewState::State;
    if (following()) return {.state = State::NoEffect, .why = following_->why()};
    if (state_.phase != AtemPhase::Stopped && !pending_.stop) return {};
    if (stopConfirmed_) return {.state = State::Confirmed};
    return {.state = stopTrouble_.isEmpty() ? State::Sent : State::NotSent,
            .seconds = now_ - stopBegan_,
            .why = stopTrouble_};
}

void Exploration::releaseStop()
{
    if (state_.phase != AtemPhase::Stopped || following()) return;
    emit decided("release stop", {});
    releasing_ = true;
    releaseBegan_ = stopSent_ = now_;
    command(ReleaseStopCommand{});
    emit happened(tr("STOP released by the operator"), EventSeverity::Warning);
}

void Exploration::setSettings(const Settings& settings)
{
    const std::uint64_t seed = options_.settings.seed;
    options_.settings = settings;
    options_.settings.seed = seed;
    emit happened(tr("the next estimate: %1, %2 draws, contacts above %3 N")
                      .arg(format::text(name(settings.method)))
                      .arg(settings.draws)
                      .arg(format::number(settings.forceThreshold, 1)),
                  EventSeverity::Note);
}

void Exploration::leave()
{
    halt();
    if (exploring(state_.phase) && !following()) command(AbortAtemCommand{});
    if (link_) link_->disarm();
    estimation_.cancel();
}

void Exploration::command(const Command& command)
{
    commandedAt_ = latest_ ? latest_->count : 0;
    const Status sent = source_.send(command);
    if (!sent)
        emit happened(tr("command not sent: %1").arg(troubleWords(link_, sent.error().text)),
                      EventSeverity::Bad);
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

void Exploration::repeatStop(AtemInput& in)
{
    const bool latched = latest_ && latest_->sample.measurement.activity == RobotActivity::Stopped;
    if (latched && state_.phase != AtemPhase::Stopped) in.stop = true;
    confirmStop(latched);
    if (state_.phase != AtemPhase::Stopped) return;
    if (answered() && releasing_ && !latched) in.stopReleased = true;
    if (releasing_ && now_ - releaseBegan_ > kReleaseFor) {
        releasing_ = false;  // the operator's request has expired
        emit happened(tr("the robot did not release STOP: hold R again"), EventSeverity::Bad);
    }
    if (now_ - stopSent_ < kRepeatStop || latched != releasing_) return;
    if (!releasing_) return sendStop();
    stopSent_ = now_;
    command(ReleaseStopCommand{});
}

void Exploration::poll(AtemInput& in)
{
    in.linkAlive = linkAlive_;
    repeatStop(in);  // also without telemetry
    if (!latest_) return;
    const Measurement& m = latest_->sample.measurement;
    in.poseChanged = estimation_.hasMoved();
    if (state_.phase == AtemPhase::Pressing) in.pressed = hasPressed();
    if (!answered()) return;
    const bool refused = m.refusal != Refusal::None;
    if (exploring(state_.phase)) refusal_ = m.refusal;
    switch (state_.phase) {
    case AtemPhase::Halting:
        in.halted = m.activity == RobotActivity::Halted || m.activity == RobotActivity::Pressed;
        break;
    case AtemPhase::Pressing:
        in.pressRefused = refused || m.activity == RobotActivity::Halted;
        break;
    case AtemPhase::Probing:
        sawProbing_ = sawProbing_ || m.activity == RobotActivity::Probing;
        in.probeRefused = refused || m.activity == RobotActivity::Halted;
        in.probeDone = m.activity == RobotActivity::Pressed && m.arm && m.arm->bin == probing_
                    && (sawProbing_ || m.arm != armBefore_);
        break;
    case AtemPhase::Idle:
    case AtemPhase::Estimating:
    case AtemPhase::ProposingProbe:
    case AtemPhase::EstimatingAgain:
    case AtemPhase::Presenting:
    case AtemPhase::Stopped:
    case AtemPhase::Failed: break;
    }
}

void Exploration::tick(const RobotMoment& moment)
{
    now_ = moment.now;
    latest_ = moment.latest;
    bus_ = moment.bus;
    const auto heardWithin = [this](double seconds) {
        return latest_ && now_ - secondsOf(latest_->arrived) <= seconds;
    };
    linkAlive_ = heardWithin(options_.linkLostAfter);
    ended_ = following() && bus_ && bus_->ended;
    estimation_.poll(latest_, heardWithin(options_.staleAfter));
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
    if (in.aborted && !exploring(state_.phase)) {
        estimation_.forgetGhost();
        if (estimation_.estimate()) forget(tr("No estimate: explore the terrain (A)"));
    }
    if (estimation_.hasLeft() && estimation_.estimate())
        forget(tr("The robot has moved: explore again (A)"));

    const AtemState before = state_;
    state_ = nextState(state_, in, options_.limits);
    if (state_.phase != before.phase) enter(before);
    driveOn();
    watchDrive();
}

/// Reports a drive without motion. At the end of the simulated ground nothing else reports it.
void Exploration::watchDrive()
{
    if (!latest_ || !linkAlive_ || !driveWatch_.poll(latest_->sample.measurement, now_)) return;
    if (source_.name() != "SIMULATED ROBOT")
        emit happened(tr("the robot says that it drives, and its tracks do not move"),
                      EventSeverity::Bad);
    else if (options_.groundFile.empty())
        emit happened(
            tr("the built-in ground ends here: drive back, or start with another --terrain"),
            EventSeverity::Bad);
    else
        emit happened(
            tr("the ground of the file %1 ends here: drive back, or start with another --terrain")
                .arg(format::fileName(QString::fromStdString(options_.groundFile))),
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
    if (!exploring(state_.phase)) askedBin_.reset();
    switch (state_.phase) {
    case AtemPhase::Halting:
        forget(tr("Exploring: the robot halts"));
        emit happened(tr("exploration requested"), EventSeverity::Note);
        command(BeginAtemCommand{});
        break;
    case AtemPhase::Pressing:
        forget(tr("Exploring: the front flippers press down"));
        command(PressCommand{.torque = options_.pressTorque});
        break;
    case AtemPhase::Estimating:
        forget(tr("Estimating …"));
        pressTook_ = state_.since - before.since;
        estimation_.begin(*latest_, commandedAt_);
        break;
    case AtemPhase::ProposingProbe:
        emit proposed();
        emit happened(tr("probe proposed at %1").arg(format::binName(probes_.current()->bin)),
                      EventSeverity::Note);
        break;
    case AtemPhase::Probing: probe(); break;
    case AtemPhase::EstimatingAgain: estimation_.take(*latest_->sample.measurement.arm); break;
    case AtemPhase::Presenting: present(before.phase == AtemPhase::ProposingProbe); break;
    case AtemPhase::Idle: end(exploring(before.phase)); break;
    case AtemPhase::Stopped:
        estimation_.cancel();
        emit happened(tr("STOP"), EventSeverity::Bad);
        if (!estimation_.estimate()) forget(tr("No estimate: STOP is latched"));
        break;
    case AtemPhase::Failed: fail(); break;
    }
}

void Exploration::probe()
{
    probing_ = probes_.current()->bin;
    probes_.withdraw();
    emit happened(tr("probe at %1 approved").arg(format::binName(probing_)), EventSeverity::Note);
    sawProbing_ = false;
    armBefore_ = latest_->sample.measurement.arm;
    if (link_) link_->approve(probing_);
    command(ProbeCommand{.bin = probing_});
}

void Exploration::present(bool unprobed)
{
    if (unprobed && state_.approvalExpired)
        emit happened(tr("no answer in time: no probe"), EventSeverity::Warning);
    else if (unprobed)
        emit happened(tr("probe refused"), EventSeverity::Note);
    probes_.withdraw();
    command(AbortAtemCommand{});
}

void Exploration::end(bool aborted)
{
    releasing_ = false;
    if (!aborted) return;
    estimation_.cancel();
    command(AbortAtemCommand{});
    emit happened(tr("exploration ended by the operator"), EventSeverity::Warning);
    if (!estimation_.estimate()) forget(tr("No estimate: explore the terrain (A)"));
}

void Exploration::fail()
{
    const QString why = failureWords();
    estimation_.cancel();
    if (linkAlive_) command(AbortAtemCommand{});
    emit happened(tr("exploration failed: %1").arg(why), EventSeverity::Bad);
    if (!estimation_.estimate()) forget(tr("No estimate: %1").arg(why));
}

void Exploration::forget(const QString& why)
{
    estimation_.forget(why);
    probes_.withdraw();
}

std::optional<PhaseTime> Exploration::time() const
{
    return phaseTime(state_, now_, options_.limits,
                     {.press = pressTook_, .probe = options_.probeSeconds});
}

QString Exploration::stateWords() const
{
    if (state_.phase == AtemPhase::Failed) return failureWords();
    switch (const StopViewState stop = stopViewState(); stop.state) {
    case StopViewState::State::Sent: return tr("STOP sent, not confirmed by the robot");
    case StopViewState::State::NotSent: return tr("STOP not sent: %1").arg(stop.why);
    case StopViewState::State::Ready:
    case StopViewState::State::Confirmed:
    case StopViewState::State::Elsewhere:
    case StopViewState::State::NoEffect: return {};
    }
    return {};
}

QString Exploration::failureWords() const
{
    QString what = format::sentence(describe(state_.failure));
    const bool refused =
        state_.failure == AtemFailure::PressRefused || state_.failure == AtemFailure::ProbeRefused;
    if (!refused || refusal_ == Refusal::None) return what;
    return what + QStringLiteral(": ") + format::sentence(describe(refusal_));
}

std::optional<int> Exploration::probingBin() const
{
    const bool probes = state_.phase == AtemPhase::Probing && !following();
    return probes ? std::optional(probing_) : std::nullopt;
}

QList<Precondition> Exploration::toDrive() const
{
    if (following()) return {Preconditions::arming(following_->why())};
    QList<Precondition> list{
        Preconditions::released(state_.phase == AtemPhase::Stopped, linkAlive_),
        Preconditions::notExploring(exploring(state_.phase)),
        Preconditions::telemetry(linkAlive_, ended_)};
    if (link_) list << Preconditions::arming(whyNotArmed());
    if (armIsOut()) list << Preconditions::armIsOut();
    return list;
}

/// Returns true if the robot reports probing although no exploration runs, for example after an abort.
bool Exploration::armIsOut() const
{
    return linkAlive_ && !following() && !exploring(state_.phase)
        && latest_->sample.measurement.activity == RobotActivity::Probing;
}

QList<Precondition> Exploration::toProbe() const
{
    if (following()) return {Preconditions::arming(following_->why())};
    QList<Precondition> list{Preconditions::telemetry(linkAlive_, ended_)};
    if (link_) list << Preconditions::arming(whyNotArmed());
    if (state_.phase != AtemPhase::ProposingProbe || !probes_.current())
        return list << Preconditions::noProbeProposed();
    if (estimation_.wasUnheard()) return list << Preconditions::wasUnheard();
    return list << Preconditions::stands(probes_.stands());
}

QList<Precondition> Exploration::toReleaseStop() const
{
    if (following()) return {Preconditions::arming(following_->why())};
    const bool confirmed = stopViewState().state == StopViewState::State::Confirmed;
    return {Preconditions::telemetry(linkAlive_, ended_),
            state_.phase == AtemPhase::Stopped ? Preconditions::stopConfirmed(confirmed, linkAlive_)
                                               : Preconditions::nothingToRelease()};
}

QString Exploration::whyNotArmed() const
{
    if (armed()) return {};
    return following() ? following_->why() : tr("not armed: press M, then hold M");
}

void Exploration::overrideWarnings()
{
    if (following() || !linkAlive_) return;  // the doubtful values are unknown
    const Measurement& m = latest_->sample.measurement;
    for (const QString& warning : ground_.overrideWarnings(m, options_.settings)) {
        emit decided("override", warning);
        emit happened(tr("overridden by the operator: %1").arg(warning), EventSeverity::Warning);
    }
}

void Exploration::endOverrides()
{
    if (!latest_) return;
    const Measurement& m = latest_->sample.measurement;
    for (const QString& reason : ground_.endOverrides(m, options_.settings))
        emit happened(tr("the override has ended: %1").arg(reason), EventSeverity::Warning);
}

QList<Precondition> Exploration::preconditions() const
{
    QList<Precondition> list{
        Preconditions::telemetry(linkAlive_, ended_),
        Preconditions::stop(state_.phase == AtemPhase::Stopped, releasing_, linkAlive_),
    };
    if (link_) list << Preconditions::arming(whyNotArmed());
    if (armIsOut()) list << Preconditions::armIsOut();
    list << Preconditions::model(estimation_.model());
    if (linkAlive_)
        list << ground_.judge(latest_->sample.measurement, options_.settings);
    else
        list << Preconditions::groundNotKnown();
    return list;
}

}  // namespace terratact
