#include "core/sim/simulated_robot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/limits.h"

namespace terratact {

namespace {

// The robot's own limits; those of the console are GateLimits (core/atem/command_gate.h).
constexpr double kMaxSpeed = 0.6;      // [m/s]
constexpr double kMargin = 0.7;        // [m] the robot keeps this distance from the terrain's ends
constexpr double kAdvanceSpeed = 0.1;  // [m/s]
constexpr double kHighestFlipper = 3.1;  // [rad]

}  // namespace

SimulatedRobot::SimulatedRobot(RobotModel robot, GroundLines ground, const Options& options)
    : robot_(std::move(robot)), stance_(robot_, std::move(ground), options.ground),
      options_(options), rng_(options.seed), slipRng_(~options.seed),
      rollRng_(options.seed ^ 0x5555), sideRng_(options.seed ^ 0x3333),
      x_(options.startX), frontTargets_{options.drivingAngle, options.drivingAngle},
      rearTarget_(options.rearAngle)
{
    settle();
}

SimulatedRobot::SimulatedRobot(RobotModel robot, TerrainProfile terrain, const Options& options)
    : SimulatedRobot(std::move(robot), GroundLines(std::move(terrain)), options)
{
}

void SimulatedRobot::command(const Command& command)
{
    refusal_ = Refusal::None;
    if (std::holds_alternative<StopCommand>(command)) return accept(RobotActivity::Stopped);
    if (std::holds_alternative<ReleaseStopCommand>(command)) {
        if (activity_ == RobotActivity::Stopped) accept(RobotActivity::Halted);
        return;
    }
    if (std::holds_alternative<ArmCommand>(command)) return;
    if (activity_ == RobotActivity::Stopped) return refuse(Refusal::StopLatched);
    if (std::holds_alternative<HaltCommand>(command)) return halt();
    if (std::holds_alternative<BeginAtemCommand>(command)) return halt();
    if (std::holds_alternative<AbortAtemCommand>(command)) return halt();
    if (activity_ == RobotActivity::Probing) return refuse(Refusal::Busy);
    if (const auto* drive = std::get_if<DriveCommand>(&command)) return obey(*drive);
    if (const auto* press = std::get_if<PressCommand>(&command)) return obey(*press);
    if (const auto* probe = std::get_if<ProbeCommand>(&command)) return obey(*probe);
    if (const auto* advance = std::get_if<AdvanceCommand>(&command)) return obey(*advance);
    if (const auto* hold = std::get_if<HoldFlippersCommand>(&command)) return obey(*hold);
}

void SimulatedRobot::halt()
{
    if (activity_ != RobotActivity::Pressed) accept(RobotActivity::Halted);
}

void SimulatedRobot::obey(const DriveCommand& drive)
{
    if (!std::isfinite(drive.speed)) return refuse(Refusal::OutOfLimits);
    startDriving(std::clamp(drive.speed, -kMaxSpeed, kMaxSpeed));
}

void SimulatedRobot::obey(const PressCommand& press)
{
    if (!(press.torque > 0.0) || press.torque > 2.0 * robot_.maxFlipperTorque)
        return refuse(Refusal::OutOfReach);
    torque_ = press.torque;
    keepFrontAngles();
    hasPressed_ = {};
    accept(RobotActivity::Pressing);
}

void SimulatedRobot::obey(const ProbeCommand& probe)
{
    if (activity_ != RobotActivity::Pressed) return refuse(Refusal::NotPressed);
    if (!robot_.armReaches(probe.bin, probe.side)) return refuse(Refusal::OutOfReach);
    probe_ = probe;
    probeLeft_ = options_.probeSeconds;
    accept(RobotActivity::Probing);
}

void SimulatedRobot::obey(const AdvanceCommand& advance)
{
    if (!standsStill()) return refuse(Refusal::Busy);
    if (!(advance.distance > 0.0 && advance.distance <= kMaxAdvance))
        return refuse(Refusal::OutOfLimits);
    startDriving(kAdvanceSpeed);
    advanceLeft_ = advance.distance;
}

void SimulatedRobot::obey(const HoldFlippersCommand& hold)
{
    if (!standsStill()) return refuse(Refusal::Busy);
    const auto fits = [](double angle) {
        return angle >= kLowestFlipper && angle <= kHighestFlipper;
    };
    if (!fits(hold.front) || !fits(hold.rear)) return refuse(Refusal::OutOfLimits);
    keepFrontAngles();
    accept(RobotActivity::Halted);
    hold_ = hold;
}

void SimulatedRobot::keepFrontAngles()
{
    for (const Side side : {Side::Left, Side::Right})
        frontTargets_[indexOf(side)] = stance_.frontAngle(side);
}

void SimulatedRobot::startDriving(double speed)
{
    if (activity_ != RobotActivity::Driving)
        slip_ = options_.slipShare * std::normal_distribution<double>()(slipRng_);
    accept(RobotActivity::Driving);
    speed_ = speed;
}

bool SimulatedRobot::standsStill() const
{
    return activity_ == RobotActivity::Halted || activity_ == RobotActivity::Pressed;
}

void SimulatedRobot::accept(RobotActivity activity)
{
    activity_ = activity;
    speed_ = 0.0;
    advanceLeft_.reset();
    hold_.reset();
}

void SimulatedRobot::refuse(Refusal refusal)
{
    refusal_ = refusal;
}

void SimulatedRobot::step(double dt)
{
    if (!(dt > 0.0) || dt > 1.0)
        throw std::invalid_argument("a simulation step lasts between 0 and 1 s");
    time_ += dt;
    const double turn = robot_.flipperSpeed * dt;
    switch (activity_) {
    case RobotActivity::Driving: drive(dt); break;
    case RobotActivity::Pressing: press(turn); break;
    case RobotActivity::Probing: probe(dt); break;
    case RobotActivity::Halted: hold(turn); break;
    case RobotActivity::Pressed:
    case RobotActivity::Stopped: break;
    }
}

// Flippers rise before the tracks move, so that they meet obstacles from above.
void SimulatedRobot::drive(double dt)
{
    const double turn = robot_.flipperSpeed * dt;
    const double raised = advanceLeft_ ? options_.advancingAngle : options_.drivingAngle;
    bool areRaised = true, areLow = true;
    for (const Side side : {Side::Left, Side::Right}) {
        const double angle = stance_.frontAngle(side);
        const bool lowers = isRaisedToAdvance_ && angle > raised;
        frontTargets_[indexOf(side)] =
            lowers ? std::max(angle - turn, raised) : std::min(angle + turn, raised);
        areRaised = areRaised && angle >= raised - 1e-9;
        areLow = areLow && !lowers;
    }
    isRaisedToAdvance_ = advanceLeft_ || !areLow;
    torque_ = 0.0;
    arm_.reset();
    double moved = 0.0;
    if (areRaised) {
        moved = speed_ * dt;
        if (advanceLeft_) moved = std::min(moved, *advanceLeft_);
        moveBy(moved);
    } else {
        settle();
    }
    if (!advanceLeft_) return;
    *advanceLeft_ -= moved;
    if (*advanceLeft_ <= 0.0) accept(RobotActivity::Halted);
}

void SimulatedRobot::moveBy(double way)
{
    const Pose before = pose();
    const double stood = x_;
    const GroundLines& ground = stance_.ground();
    x_ = std::clamp(x_ + way, ground.begin() + kMargin, ground.end() - kMargin);
    // otherwise it would appear further on, and its tracks would report that way at once
    if (!settle()) x_ = stood;
    travelled_ += (1.0 + slip_) * trackWay(before, pose());
}

void SimulatedRobot::press(double turn)
{
    arm_.reset();
    for (const Side side : {Side::Left, Side::Right})
        if (!hasPressed_[indexOf(side)]) frontTargets_[indexOf(side)] -= turn;
    settle();
    if (activity_ != RobotActivity::Pressing) return;
    for (const Side side : {Side::Left, Side::Right})
        hasPressed_[indexOf(side)] = hasPressed_[indexOf(side)]
                                  || stance_.frontTorque(side) >= torque_ / 2.0
                                  || frontTargets_[indexOf(side)] < kLowestFlipper;
    if (!hasPressed_[0] || !hasPressed_[1]) return;
    accept(RobotActivity::Pressed);
    settle();
}

void SimulatedRobot::probe(double dt)
{
    probeLeft_ -= dt;
    if (probeLeft_ > 0.0) return;
    const double height = stance_.truth(probe_.side)[static_cast<std::size_t>(probe_.bin)];
    arm_ = ArmReading{.bin = probe_.bin,
                      .height = height + robot_.armSd * std::normal_distribution<double>()(rng_),
                      .sd = robot_.armSd,
                      .side = probe_.side};
    accept(RobotActivity::Pressed);
}

void SimulatedRobot::hold(double turn)
{
    if (!hold_) return;
    const auto towards = [turn](double from, double to) {
        return std::abs(to - from) <= turn ? to : from + std::copysign(turn, to - from);
    };
    bool there = true;
    for (double& target : frontTargets_) {
        target = towards(target, hold_->front);
        there = there && target == hold_->front;
    }
    rearTarget_ = towards(rearTarget_, hold_->rear);
    there = there && rearTarget_ == hold_->rear;
    arm_.reset();
    settle();
    if (there) hold_.reset();
}

/// Finds the rest pose for the present position and flipper drive. Returns false and keeps the old
/// pose if there is none.
bool SimulatedRobot::settle()
{
    FlipperTargets targets{.front = frontTargets_, .rear = rearTarget_};
    if (activity_ == RobotActivity::Pressed) targets.torque = torque_;
    if (stance_.settle(x_, targets)) return true;
    refuse(Refusal::NoRestPose);
    accept(RobotActivity::Halted);
    return false;
}

Measurement SimulatedRobot::measure()
{
    Measurement m = stance_.tracks() ? trackReadings() : planeReadings();
    m.time = time_;
    m.activity = activity_;
    m.refusal = refusal_;
    m.arm = arm_;
    m.travelled = travelled_;
    m.turned = 0.0;  // the simulated robot drives along x
    return m;
}

Measurement SimulatedRobot::planeReadings()
{
    const Proprioception s =
        noisy(exactReadings(robot_, stance_.plane()), options_.noise, robot_.forceSaturation, rng_);
    Measurement m;
    m.pitch = s.pitch;
    m.roll = options_.noise.pitch * std::normal_distribution<double>()(rollRng_);
    m.frontLeft = m.frontRight = s.front;
    m.rearLeft = m.rearRight = s.rear;
    m.frontLeftCurrent = m.frontRightCurrent = s.frontCurrent.value_or(0.0);
    m.rearLeftCurrent = m.rearRightCurrent = s.rearCurrent.value_or(0.0);
    for (std::size_t e = 0; e < m.force.size(); ++e) m.force[e] = s.force[e].value_or(0.0);
    m.missing = missingFeatures(s);
    m.sides = sidesOf(m, options_.noise, robot_, sideRng_);
    return m;
}

Measurement SimulatedRobot::trackReadings()
{
    return measurementOf(noisy(exactReadings(robot_, *stance_.tracks()), options_.noise,
                               robot_.forceSaturation, rng_));
}

}  // namespace terratact
