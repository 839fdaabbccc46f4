#include "core/robot/measurement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "core/base/message.h"

namespace terratact {
namespace {

/// In the order of MotorCurrents: motor ^ 1 is the other one of its axle.
constexpr std::array<double Measurement::*, kMotors> kMotorCurrents{
    &Measurement::frontLeftCurrent, &Measurement::frontRightCurrent, &Measurement::rearLeftCurrent,
    &Measurement::rearRightCurrent};

constexpr std::size_t axleFeature(std::size_t motor)
{
    return motor < 2 ? kFrontCurrentFeature : kRearCurrentFeature;
}

}  // namespace

SourceText describe(RobotActivity activity)
{
    switch (activity) {
    case RobotActivity::Halted: return TR_NOOP("core", "halted");
    case RobotActivity::Driving: return TR_NOOP("core", "driving");
    case RobotActivity::Pressing: return TR_NOOP("core", "pressing the front flippers down");
    case RobotActivity::Pressed: return TR_NOOP("core", "front flippers pressed to the ground");
    case RobotActivity::Probing: return TR_NOOP("core", "probing with the arm");
    case RobotActivity::Stopped: return TR_NOOP("core", "stopped");
    }
    throw std::invalid_argument("describe: no such RobotActivity");
}

SourceText describe(Refusal refusal)
{
    switch (refusal) {
    case Refusal::None: return TR_NOOP("core", "nothing refused");
    case Refusal::StopLatched: return TR_NOOP("core", "STOP is latched");
    case Refusal::Busy: return TR_NOOP("core", "the robot is busy");
    case Refusal::OutOfReach: return TR_NOOP("core", "the arm does not reach that bin");
    case Refusal::NotPressed:
        return TR_NOOP("core", "the front flippers are not pressed to the ground");
    case Refusal::NoRestPose: return TR_NOOP("core", "the robot finds no pose to rest in there");
    case Refusal::NotArmed: return TR_NOOP("core", "the robot is not armed");
    case Refusal::WrongEpoch: return TR_NOOP("core", "the command is late or not of this arming");
    case Refusal::OutOfLimits: return TR_NOOP("core", "the command is beyond the robot's limits");
    }
    throw std::invalid_argument("describe: no such Refusal");
}

std::optional<double> meanOfSides(const std::optional<double>& left,
                                  const std::optional<double>& right)
{
    if (left && right) return (*left + *right) / 2.0;
    if (left) return *left;
    if (right) return *right;
    return std::nullopt;
}

MotorCurrents motorCurrents(const Measurement& m)
{
    MotorCurrents currents;
    for (std::size_t motor = 0; motor < currents.size(); ++motor)
        if (!m.missing[axleFeature(motor)] && !m.missingMotors[motor])
            currents[motor] = m.*kMotorCurrents[motor];
    return currents;
}

void setCurrents(Measurement& m, const MotorCurrents& currents)
{
    for (std::size_t motor = 0; motor < currents.size(); ++motor) {
        const bool isMissing = !currents[motor], isOtherMissing = !currents[motor ^ 1U];
        m.*kMotorCurrents[motor] = currents[motor].value_or(0.0);
        m.missing[axleFeature(motor)] = isMissing && isOtherMissing;
        m.missingMotors[motor] = isMissing && !isOtherMissing;
    }
}

void setSides(Measurement& m, const SideForces& sides)
{
    m.sides = sides;
    for (std::size_t e = 0; e < m.force.size(); ++e) {
        m.force[e] = meanOfSides(sides.left[e], sides.right[e]).value_or(0.0);
        m.missing[kFirstForceFeature + e] = !sides.knows(e);
    }
}

Proprioception proprioception(const Measurement& m)
{
    Proprioception s;
    s.pitch = m.pitch;
    s.front = (m.frontLeft + m.frontRight) / 2.0;
    s.rear = (m.rearLeft + m.rearRight) / 2.0;
    const MotorCurrents currents = motorCurrents(m);
    s.frontCurrent = meanOfSides(currents[0], currents[1]);
    s.rearCurrent = meanOfSides(currents[2], currents[3]);
    for (std::size_t i = 0; i < m.force.size(); ++i)
        if (!m.missing[kFirstForceFeature + i]) s.force[i] = m.force[i];
    return s;
}

double shownFeature(const Measurement& m, std::size_t feature, double value)
{
    return m.missing[feature] ? std::numeric_limits<double>::quiet_NaN() : value;
}

MissingFeatures missingFeatures(const Proprioception& s)
{
    MissingFeatures missing;
    missing[kFrontCurrentFeature] = !s.frontCurrent;
    missing[kRearCurrentFeature] = !s.rearCurrent;
    for (std::size_t i = 0; i < s.force.size(); ++i) missing[kFirstForceFeature + i] = !s.force[i];
    return missing;
}

double turnBetween(double from, double to)
{
    return std::remainder(to - from, 2.0 * std::numbers::pi);
}

double flipperAsymmetry(const Measurement& m)
{
    return std::max(std::abs(m.frontLeft - m.frontRight), std::abs(m.rearLeft - m.rearRight));
}

}  // namespace terratact
