#include "core/robot/measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace terratact {

std::string describe(RobotActivity activity)
{
    switch (activity) {
    case RobotActivity::Halted: return "halted";
    case RobotActivity::Driving: return "driving";
    case RobotActivity::Pressing: return "pressing the front flippers down";
    case RobotActivity::Pressed: return "front flippers pressed to the ground";
    case RobotActivity::Probing: return "probing with the arm";
    case RobotActivity::Stopped: return "stopped";
    }
    throw std::invalid_argument("describe: no such RobotActivity");
}

std::string describe(Refusal refusal)
{
    switch (refusal) {
    case Refusal::None: return "nothing refused";
    case Refusal::StopLatched: return "STOP is latched";
    case Refusal::Busy: return "the robot is busy";
    case Refusal::OutOfReach: return "the arm does not reach that bin";
    case Refusal::NotPressed: return "the front flippers are not pressed to the ground";
    case Refusal::NoRestPose: return "the robot finds no pose to rest in there";
    case Refusal::NotArmed: return "the robot is not armed";
    case Refusal::WrongEpoch: return "the command is late or not of this arming";
    case Refusal::OutOfLimits: return "the command is beyond the robot's limits";
    }
    throw std::invalid_argument("describe: no such Refusal");
}

Proprioception proprioception(const Measurement& m)
{
    Proprioception s;
    s.pitch = m.pitch;
    s.front = (m.frontLeft + m.frontRight) / 2.0;
    s.rear = (m.rearLeft + m.rearRight) / 2.0;
    if (!m.missing[kFrontCurrentFeature])
        s.frontCurrent = (m.frontLeftCurrent + m.frontRightCurrent) / 2.0;
    if (!m.missing[kRearCurrentFeature])
        s.rearCurrent = (m.rearLeftCurrent + m.rearRightCurrent) / 2.0;
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
