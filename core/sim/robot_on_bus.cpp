#include "core/sim/robot_on_bus.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/base/named.h"
#include "core/wire/telemetry.h"

namespace terratact {
namespace {

constexpr auto kRobotFaultNames = namesOf<RobotFault>(
    "none", "silence", "stuck-imu", "dead-element", "refuse-probe", "slow-arm", "reboot");

constexpr double kMaxStepTime = 0.05;  // [s] largest step of simulated time
constexpr double kSlowArm = 3.0;

bool moves(const Command& command)
{
    return std::holds_alternative<DriveCommand>(command)
        || std::holds_alternative<AdvanceCommand>(command);
}

}  // namespace

std::string_view name(RobotFault fault)
{
    return nameIn(kRobotFaultNames, fault);
}

std::optional<RobotFault> robotFaultFromName(std::string_view text)
{
    return valueIn<RobotFault>(kRobotFaultNames, text);
}

RobotOnBus::RobotOnBus(RobotModel model, SimulatedRobot robot, const Options& options)
    : model_(std::move(model)), robot_(std::move(robot)), options_(options),
      receiver_(options.firstEpoch, options.firstChallenge)
{
    if (!(options.speed > 0.0 && options.speed <= 1000.0))
        throw std::invalid_argument("RobotOnBus: the speed must lie above 0 and at most at 1000");
    if (!(options.faultAt >= 0.0))
        throw std::invalid_argument("RobotOnBus: a fault cannot begin before the robot");
    if (options.sensorFault) faultySensors_.emplace(*options.sensorFault, model_, 1);
}

bool RobotOnBus::faulty(RobotFault fault) const
{
    return options_.fault == fault && began_ && *last_ - *began_ >= options_.faultAt;
}

bool RobotOnBus::mute() const
{
    const bool booting =
        faulty(RobotFault::Reboot) && *last_ - *began_ < options_.faultAt + kRebootTime;
    return booting || faulty(RobotFault::Silence);
}

std::vector<CanFrame> RobotOnBus::receive(const CanFrame& frame, double now)
{
    if (mute()) return {};
    const CommandReceiver::Answer answer = receiver_.receive(frame, now);
    if (answer.kind) {
        lastCommand_ = answer.kind;
        lastCounter_ = answer.counter;
    }
    switch (answer.verdict) {
    case CommandVerdict::Heartbeat:
        return {robotHeartbeat(*answer.token, heartbeatCounter_++, answer.challenge)};
    case CommandVerdict::Accepted: obey(*answer.command); break;
    case CommandVerdict::NotArmed:
    case CommandVerdict::NoHeartbeat: refuse(Refusal::NotArmed); break;
    case CommandVerdict::WrongEpoch: refuse(Refusal::WrongEpoch); break;
    case CommandVerdict::TooLate:
        // Drive commands in transit when a key was released are no error to report.
        if (answer.kind != FrameKind::Drive) refuse(Refusal::WrongEpoch);
        break;
    case CommandVerdict::NotACommand:
    case CommandVerdict::Malformed:
    case CommandVerdict::Repeated:
    case CommandVerdict::WrongSequence: break;
    }
    return {};
}

void RobotOnBus::obey(const Command& command)
{
    refusal_.reset();
    const bool stopped = robot_.activity() == RobotActivity::Stopped;
    const auto* arm = std::get_if<ArmCommand>(&command);
    if (arm && arm->armed && stopped) {
        receiver_.disarm();
        return refuse(Refusal::StopLatched);
    }
    if (std::holds_alternative<StopCommand>(command)
        || std::holds_alternative<AbortAtemCommand>(command) || (arm && !arm->armed))
        exploring_ = false;
    if (exploring_ && moves(command)) return refuse(Refusal::Busy);
    if (std::holds_alternative<ProbeCommand>(command) && faulty(RobotFault::RefuseProbe))
        return refuse(Refusal::OutOfReach);
    if (arm && !arm->armed && !stopped) return robot_.command(HaltCommand{});
    robot_.command(command);
    if (std::holds_alternative<BeginAtemCommand>(command)) exploring_ = !stopped;
}

std::vector<CanFrame> RobotOnBus::tick(double now)
{
    if (!began_) {
        began_ = last_ = now;
        due_ = now;
    }
    const double dt = std::max(0.0, now - *last_);
    last_ = std::max(now, *last_);
    haltForSilence(receiver_.tick(now));
    if (faulty(RobotFault::Reboot) && !std::exchange(rebooted_, true)) reboot();
    live(std::min(dt, kMaxTick) * options_.speed);
    if (*last_ < due_) return {};
    due_ = std::max(due_ + kPeriod, *last_);  // missed lines are not repeated
    return mute() ? std::vector<CanFrame>{} : telemetry();
}

void RobotOnBus::haltForSilence(CommandReceiver::Silence silence)
{
    if (silence == CommandReceiver::Silence::None) return;
    const RobotActivity activity = robot_.activity();
    const bool ofDrive = silence == CommandReceiver::Silence::OfDrive;
    if (ofDrive && activity != RobotActivity::Driving)
        return;  // something else has ended the drive
    if (!ofDrive) exploring_ = false;
    if (activity != RobotActivity::Stopped) robot_.command(HaltCommand{});
}

void RobotOnBus::live(double dt)
{
    if (faulty(RobotFault::SlowArm) && robot_.activity() == RobotActivity::Probing) dt /= kSlowArm;
    const int steps = static_cast<int>(std::ceil(dt / kMaxStepTime - 1e-9));
    for (int i = 0; i < steps; ++i) robot_.step(dt / steps);
}

void RobotOnBus::reboot()
{
    receiver_.disarm();
    receiver_ = CommandReceiver(receiver_.epoch(), receiver_.nextChallenge());
    robot_.command(ReleaseStopCommand{});
    robot_.command(HaltCommand{});
    exploring_ = false;
    refusal_.reset();
    lastCommand_.reset();
    lastCounter_ = telemetryCounter_ = heartbeatCounter_ = 0;
}

Measurement RobotOnBus::measured()
{
    Measurement m = robot_.measure();
    if (faulty(RobotFault::StuckImu)) {
        if (!stuck_) stuck_ = m;
        m.pitch = stuck_->pitch;
        m.roll = stuck_->roll;
    }
    if (faultySensors_ && *last_ - *began_ >= options_.faultAt) return faultySensors_->apply(m);
    return m;
}

std::vector<CanFrame> RobotOnBus::telemetry()
{
    const Measurement m = measured();
    SensorLine line = sensorLineOf(m, model_);
    if (faulty(RobotFault::DeadElement)) {
        const bool left = haveElement(model_.forceArrays, Side::Left, 3);
        line.voltages[left ? 1 : 3]->front() = 0.0;  // element 4
    }
    const RobotStatus status{.epoch = receiver_.epoch(),
                             .activity = m.activity,
                             .refusal = refusal_.value_or(m.refusal),
                             .armed = receiver_.armed(),
                             .exploring = exploring_,
                             .lastCommand = lastCommand_,
                             .lastCounter = lastCounter_};
    std::vector<CanFrame> frames{frameOf(status, telemetryCounter_)};
    for (const CanFrame& frame : framesOf(line, telemetryCounter_, lineExtent(model_)))
        frames.push_back(frame);
    ++telemetryCounter_;
    return frames;
}

}  // namespace terratact
