#include "core/sim/simulated_robot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace terratact {

namespace {

constexpr double kMaxSpeed = 0.6;  // [m/s]
constexpr double kMargin = 0.7;    // [m] the robot stays this far from the terrain's ends

}  // namespace

SimulatedRobot::SimulatedRobot(RobotModel robot, TerrainProfile terrain, const Options& options)
    : robot_(std::move(robot)), terrain_(std::move(terrain)), options_(options), rng_(options.seed),
      x_(options.startX), frontTarget_(options.drivingAngle)
{
    settle();
}

void SimulatedRobot::command(const Command& command)
{
    refusal_ = Refusal::None;
    if (std::holds_alternative<StopCommand>(command)) return accept(RobotActivity::Stopped);
    if (std::holds_alternative<ReleaseStopCommand>(command)) {
        if (activity_ == RobotActivity::Stopped) accept(RobotActivity::Halted);
        return;
    }
    if (activity_ == RobotActivity::Stopped) return refuse(Refusal::StopLatched);
    if (std::holds_alternative<HaltCommand>(command)) {
        if (activity_ != RobotActivity::Pressed) accept(RobotActivity::Halted);
        return;
    }
    if (activity_ == RobotActivity::Probing) return refuse(Refusal::Busy);
    if (const auto* drive = std::get_if<DriveCommand>(&command)) {
        speed_ = std::clamp(drive->speed, -kMaxSpeed, kMaxSpeed);
        activity_ = RobotActivity::Driving;
    } else if (const auto* press = std::get_if<PressCommand>(&command)) {
        if (!(press->torque > 0.0) || press->torque > 2.0 * robot_.maxFlipperTorque)
            return refuse(Refusal::OutOfReach);
        torque_ = press->torque;
        frontTarget_ = rest_.pose.front;
        accept(RobotActivity::Pressing);
    } else if (const auto* probe = std::get_if<ProbeCommand>(&command)) {
        if (activity_ != RobotActivity::Pressed) return refuse(Refusal::NotPressed);
        if (!robot_.armReaches(probe->bin)) return refuse(Refusal::OutOfReach);
        probeBin_ = probe->bin;
        probeLeft_ = options_.probeSeconds;
        accept(RobotActivity::Probing);
    }
}

void SimulatedRobot::accept(RobotActivity activity)
{
    activity_ = activity;
    speed_ = 0.0;
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
    case RobotActivity::Driving: {
        // Flippers come up before the tracks move, so that they meet obstacles from above.
        frontTarget_ = std::min(rest_.pose.front + turn, options_.drivingAngle);
        if (rest_.pose.front >= options_.drivingAngle - 1e-9)
            x_ = std::clamp(x_ + speed_ * dt, terrain_.begin() + kMargin, terrain_.end() - kMargin);
        torque_ = 0.0;
        arm_.reset();
        settle();
        break;
    }
    case RobotActivity::Pressing:
        arm_.reset();
        frontTarget_ -= turn;
        settle();
        if (activity_ == RobotActivity::Pressing
            && (rest_.frontTorque >= torque_ || frontTarget_ < kLowestFlipper)) {
            accept(RobotActivity::Pressed);
            settle();
        }
        break;
    case RobotActivity::Probing:
        probeLeft_ -= dt;
        if (probeLeft_ <= 0.0) {
            const double height = truth()[static_cast<std::size_t>(probeBin_)];
            arm_ = ArmReading{probeBin_,
                              height + robot_.armSd * std::normal_distribution<double>()(rng_),
                              robot_.armSd};
            accept(RobotActivity::Pressed);
        }
        break;
    case RobotActivity::Halted:
    case RobotActivity::Pressed:
    case RobotActivity::Stopped: break;
    }
}

/// Finds the rest pose for the present position and flipper drive; keeps the old one where there is none.
void SimulatedRobot::settle()
{
    const FlipperDrive front = activity_ == RobotActivity::Pressed
                                 ? FlipperDrive{PressTorque{torque_, rest_.pose.front + 0.1}}
                                 : FlipperDrive{HoldAngle{frontTarget_}};
    const auto rest =
        restPose(robot_, terrain_, x_, front, HoldAngle{options_.rearAngle}, rest_.pose.pitch);
    if (rest) {
        rest_ = *rest;
    } else {
        refuse(Refusal::NoRestPose);
        accept(RobotActivity::Halted);
    }
}

Measurement SimulatedRobot::measure()
{
    const Proprioception s =
        noisy(exactReadings(robot_, rest_), options_.noise, robot_.forceSaturation, rng_);
    Measurement m;
    m.time = time_;
    m.pitch = s.pitch;
    m.frontLeft = m.frontRight = s.front;
    m.rearLeft = m.rearRight = s.rear;
    m.frontLeftCurrent = m.frontRightCurrent = s.frontCurrent.value_or(0.0);
    m.rearLeftCurrent = m.rearRightCurrent = s.rearCurrent.value_or(0.0);
    for (std::size_t e = 0; e < m.force.size(); ++e) m.force[e] = s.force[e].value_or(0.0);
    m.activity = activity_;
    m.refusal = refusal_;
    m.arm = arm_;
    return m;
}

Heights SimulatedRobot::truth() const
{
    return binHeights(terrain_, imuPosition(robot_, rest_.pose));
}

}  // namespace terratact
