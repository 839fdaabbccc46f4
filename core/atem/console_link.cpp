#include "core/atem/console_link.h"

#include <utility>

namespace terratact {
namespace {

// Returns true if the command ends the approval of a probe.
bool endsApproval(const Command& command)
{
    return std::holds_alternative<StopCommand>(command)
        || std::holds_alternative<HaltCommand>(command)
        || std::holds_alternative<AbortAtemCommand>(command)
        || std::holds_alternative<ProbeCommand>(command);
}

bool isMotion(const Command& command)
{
    return std::holds_alternative<DriveCommand>(command)
        || std::holds_alternative<PressCommand>(command)
        || std::holds_alternative<ProbeCommand>(command)
        || std::holds_alternative<HoldFlippersCommand>(command)
        || std::holds_alternative<AdvanceCommand>(command);
}

constexpr std::uint16_t kAnyChallenge = 1;  // replaces an answer of the robot

double orNever(std::optional<double> age)
{
    return age.value_or(GateView::kNever);
}

bool isDue(const std::optional<double>& last, double period, double now)
{
    // A tolerance of one millisecond: a caller that ticks every 20 ms must not skip a tick.
    return !last || now - *last >= period - 1e-3 || now < *last;
}

// Returns true if the console must send Disarm to the robot.
bool mustSendDisarm(const ArmingState& before, const ArmingState& after)
{
    const bool was = before.phase == ArmingPhase::Armed || before.phase == ArmingPhase::Requested;
    return was && after.phase == ArmingPhase::Disarmed && after.cause != DisarmCause::RobotDisarmed
        && after.cause != DisarmCause::EpochChanged;
}

}  // namespace

ConsoleLink::ConsoleLink(RobotModel robot, const Options& options)
    : listener_(std::move(robot)), options_(options), rng_(options.seed)
{
}

std::optional<Measurement> ConsoleLink::receive(const CanFrame& frame, bool echo, double now)
{
    if (echo) {
        listener_.judge(frame, now);
        return std::nullopt;
    }
    const std::uint64_t consoles = listener_.counters().fromConsole;
    std::optional<Measurement> measurement = listener_.receive(frame, now);
    if (listener_.counters().fromConsole != consoles) foreignSeen_ = now;
    if (const auto token = listener_.token()) {
        freshness_.echoed(*token);
        if (freshness_.answersAnew(*token)) challenge_ = listener_.challenge();
    }
    return measurement;
}

void ConsoleLink::operatorAlive(double now)
{
    operatorSeen_ = now;
}

void ConsoleLink::approve(const ProbeCommand& probe, double now)
{
    approved_ = Approved{probe, now};
}

bool ConsoleLink::foreignSender(double now) const
{
    return foreignSeen_ && now - *foreignSeen_ < kForeignFor;
}

bool ConsoleLink::linkGood(double now) const
{
    const auto within = [](const std::optional<double>& age, double limit) {
        return age && *age >= 0.0 && *age <= limit;
    };
    return listener_.status() && listener_.link(FrameKind::RobotStatus, now) == LinkState::Good
        && within(listener_.age(FrameKind::RobotStatus, now), options_.gate.statusAge)
        && within(freshness_.age(now), options_.gate.answerAge);
}

GateView ConsoleLink::gateView(double now) const
{
    GateView view{.link = listener_.link(FrameKind::RobotStatus, now),
                  .statusAge = orNever(listener_.age(FrameKind::RobotStatus, now)),
                  .answerAge = orNever(freshness_.age(now)),
                  .challenge = challenge_,
                  .operatorAge = operatorSeen_ ? now - *operatorSeen_ : GateView::kNever,
                  .moves = moves(now),
                  .foreignSender = foreignSender(now),
                  .stopLatched = stopLatched_,
                  .arming = arming_,
                  .robot = listener_.status(),
                  .approval = std::nullopt};
    if (approved_)
        view.approval = ProbeApproval{
            .bin = approved_->probe.bin, .age = now - approved_->at, .side = approved_->probe.side};
    return view;
}

bool ConsoleLink::moves(double now) const
{
    const auto& robot = listener_.status();
    if (driving_ || !robot || stopLatched_ || arming_.cause == DisarmCause::OperatorAbsent)
        return true;
    const bool stands = robot->activity == RobotActivity::Halted
                     || robot->activity == RobotActivity::Pressed
                     || robot->activity == RobotActivity::Stopped;
    return !stands || (motionSent_ && now - *motionSent_ < kMotionShows);
}

GateRefusal ConsoleLink::refusalOf(const Command& command, std::uint16_t challenge,
                                   double now) const
{
    GateView view = gateView(now);
    view.challenge = challenge;
    if (std::holds_alternative<ReleaseStopCommand>(command))
        view.stopLatched = false;  // the stop is about to be released
    return judge(frameOfNext(command, challenge), view, options_.gate);
}

CanFrame ConsoleLink::frameOfNext(const Command& command, std::uint16_t challenge) const
{
    const std::uint8_t epoch = listener_.status() ? listener_.status()->epoch : std::uint8_t{0};
    return frameOf(command, epoch, counters_[static_cast<std::size_t>(kindOf(command))], challenge);
}

std::variant<CanFrame, GateRefusal, ConsoleLink::Waits> ConsoleLink::send(const Command& command,
                                                                          double now)
{
    // These end before the gate judges: they must end even if the frame is refused.
    driving_.reset();
    waiting_.reset();
    if (std::holds_alternative<StopCommand>(command)) stopLatched_ = true;

    GateRefusal refusal = refusalOf(command, challenge_, now);
    const bool waits = challenge_ == 0 && refusal == GateRefusal::NotAnswered
                    && (refusal = refusalOf(command, kAnyChallenge, now)) == GateRefusal::None;
    if (waits) {
        waiting_ = Waiting{command, now};
        return Waits{};
    }
    const bool releases = std::holds_alternative<ReleaseStopCommand>(command);
    if (releases && (refusal == GateRefusal::None || refusal == GateRefusal::NotStopped))
        stopLatched_ = false;
    if (endsApproval(command)) approved_.reset();
    if (refusal != GateRefusal::None) return refusal;
    const CanFrame frame = frameOfNext(command, challenge_);
    left(command, now);
    return frame;
}

// Records a frame that the gate has passed.
void ConsoleLink::left(const Command& command, double now)
{
    ++counters_[static_cast<std::size_t>(kindOf(command))];
    if (isMotion(command)) motionSent_ = now;
    if (const auto* drive = std::get_if<DriveCommand>(&command)) driving_ = Driving{*drive, now};
    const auto* arm = std::get_if<ArmCommand>(&command);
    if (arm && !arm->armed) disarmSent_ = now;
    if (!arm && safety(command) == 0) return;
    challenge_ = 0;  // the robot voids its challenges
    freshness_.beginAnew();
    lastBeat_.reset();  // makes the next heartbeat due at once
}

std::optional<CanFrame> ConsoleLink::passed(const Command& command, double now)
{
    const auto sent = send(command, now);
    const auto* frame = std::get_if<CanFrame>(&sent);
    return frame ? std::optional(*frame) : std::nullopt;
}

std::vector<CanFrame> ConsoleLink::tick(double now)
{
    std::vector<CanFrame> out;
    arm(now, out);
    sendWaiting(now, out);
    keepDriving(now, out);
    beat(now, out);
    return out;
}

void ConsoleLink::sendWaiting(double now, std::vector<CanFrame>& out)
{
    if (!waiting_) return;
    const Waiting waiting = *waiting_;
    const double waited = now - waiting.since;
    if (!(waited >= 0.0 && waited < kWaits)) return waiting_.reset();
    if (const auto frame = passed(waiting.command, now)) out.push_back(*frame);
    if (waiting_) waiting_->since = waiting.since;
}

void ConsoleLink::arm(double now, std::vector<CanFrame>& out)
{
    if (!linkGood(now))
        goodSince_.reset();
    else if (!goodSince_)
        goodSince_ = now;
    const GateView gate = gateView(now);
    const auto& robot = listener_.status();
    const ArmingInput in{
        .now = now,
        .wanted = std::exchange(wanted_, false),
        .confirmed = std::exchange(confirmed_, false),
        .disarmed = std::exchange(disarmed_, false),
        .stopLatched = stopLatched_ || (robot && robot->activity == RobotActivity::Stopped),
        .operatorPresent =
            gate.operatorAge >= 0.0 && gate.operatorAge <= operatorPatience(gate, options_.gate),
        .foreignSender = gate.foreignSender,
        .linkGoodFor = view(now).goodFor,
        .robotArmed = robot && robot->armed,
        .robotEpoch = robot ? robot->epoch : std::uint8_t{0}};
    const ArmingState before = arming_;
    arming_ = nextArming(arming_, in, options_.arming);
    if (before.phase != ArmingPhase::Requested && arming_.phase == ArmingPhase::Requested) {
        if (const auto frame = passed(ArmCommand{true}, now)) out.push_back(*frame);
    }
    const bool tells = mustSendDisarm(before, arming_);
    if (tells) {
        if (const auto frame = passed(ArmCommand{false}, now)) out.push_back(*frame);
    }
    if (arming_.phase == ArmingPhase::Requested || tells)
        owesDisarm_ = true;
    else if (!robot || !robot->armed)
        owesDisarm_ = false;
    disarmRobot(now, out);
}

// Disarms a robot that reports "armed" while this console is not: its Disarm was lost, or its Arm
// came late. A robot that another console may have armed is not touched.
void ConsoleLink::disarmRobot(double now, std::vector<CanFrame>& out)
{
    const bool armed = listener_.status() && listener_.status()->armed;
    if (arming_.phase != ArmingPhase::Disarmed || !armed) return;
    if (foreignSender(now) && !owesDisarm_) return;
    if (!isDue(disarmSent_, kDisarmPeriod, now)) return;
    if (const auto frame = passed(ArmCommand{false}, now)) out.push_back(*frame);
}

void ConsoleLink::keepDriving(double now, std::vector<CanFrame>& out)
{
    if (!driving_ || !isDue(driving_->sent, kDrivePeriod, now)) return;
    auto frame = passed(driving_->command, now);
    if (!frame) frame = passed(HaltCommand{}, now);  // the drive has ended
    if (frame) out.push_back(*frame);
}

void ConsoleLink::beat(double now, std::vector<CanFrame>& out)
{
    if (!isDue(lastBeat_, kHeartbeatPeriod, now)) return;
    std::uint8_t& counter = counters_[static_cast<std::size_t>(FrameKind::ConsoleHeartbeat)];
    const auto token = static_cast<std::uint16_t>(rng_() >> 48U);
    const CanFrame frame = consoleHeartbeat(token, counter);
    if (judge(frame, gateView(now), options_.gate) != GateRefusal::None) return;
    ++counter;
    lastBeat_ = now;
    freshness_.sent(token, now);
    out.push_back(frame);
}

LinkView ConsoleLink::view(double now) const
{
    return {.state = listener_.link(FrameKind::RobotStatus, now),
            .statusAge = listener_.age(FrameKind::RobotStatus, now),
            .answerAge = freshness_.age(now),
            .goodFor = goodSince_ && linkGood(now) ? now - *goodSince_ : 0.0,
            .foreignSender = foreignSender(now),
            .arming = arming_,
            .robot = listener_.status(),
            .moves = moves(now)};
}

}  // namespace terratact
