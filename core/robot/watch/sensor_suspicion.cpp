#include "core/robot/watch/sensor_suspicion.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace terratact {
namespace {

constexpr double kNotableWay = 0.05;  // [m]

std::string stuckWords(const SensorSuspicion& s)
{
    if (s.way >= kNotableWay)
        return fmt::format("not changed for {:.0f} s while the robot drove {:.1f} m, stuck?",
                           s.amount, s.way);
    return fmt::format("not changed for {:.0f} s, not even by noise, stuck?", s.amount);
}

}  // namespace

bool isSuspected(const std::vector<SensorSuspicion>& suspicions, Sensor sensor)
{
    return std::any_of(suspicions.begin(), suspicions.end(),
                       [sensor](const SensorSuspicion& s) { return s.sensor == sensor; });
}

std::string describeTrouble(const SensorSuspicion& s)
{
    switch (s.trouble) {
    case SensorTrouble::Stuck: return stuckWords(s);
    case SensorTrouble::Spikes: return "jumps away and comes back, loose contact?";
    case SensorTrouble::OutOfRange: return "reads what the robot cannot do";
    case SensorTrouble::Flipped: return "changes the wrong way, sign flipped?";
    case SensorTrouble::SwappedAxles: return "moves with the other axle, front and rear swapped?";
    case SensorTrouble::Late: return "still changes when the robot stands still, late?";
    case SensorTrouble::NoLoad: return "no load while the flippers press, disconnected?";
    case SensorTrouble::LoadedFree: return "loaded while nothing presses, drifted?";
    case SensorTrouble::SidesDiffer: return "left and right differ by the same at every press";
    case SensorTrouble::OffGround:
        return "does not fit the ground driven over, offset or sign flipped?";
    case SensorTrouble::WrongOrder: return "load where no ground was, order reversed?";
    case SensorTrouble::BothWays:
        return "does not fit the same ground driven in both directions, zero shifted?";
    }
    throw std::invalid_argument("describe: no such SensorTrouble");
}

std::string describe(const SensorSuspicion& s)
{
    return fmt::format("{}: {}", describe(s.sensor), describeTrouble(s));
}

}  // namespace terratact
