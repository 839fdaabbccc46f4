#include "core/robot/sensor_suspicion.h"

#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

namespace terratact {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// With the unit that the operator reads.
std::string valueOf(Sensor sensor, double value)
{
    switch (kindOf(sensor)) {
    case SensorKind::Attitude:
    case SensorKind::Angle: return fmt::format("{:.0f}°", kDegrees * value);
    case SensorKind::Current: return fmt::format("{:.1f} A", value);
    case SensorKind::Force: return fmt::format("{:.1f} N", value);
    case SensorKind::Way: return fmt::format("{:.2f} m", value);
    }
    throw std::invalid_argument("describe: no such SensorKind");
}

std::string stuckWords(const SensorSuspicion& s)
{
    const std::string_view sensor = describe(s.sensor);
    if (s.way >= 0.05)
        return fmt::format("{} has not changed for {:.0f} s while the robot drove {:.1f} m: stuck?",
                           sensor, s.amount, s.way);
    return fmt::format("{} has not changed for {:.0f} s, not even by noise: stuck?", sensor,
                       s.amount);
}

}  // namespace

std::string describe(const SensorSuspicion& s)
{
    const std::string_view sensor = describe(s.sensor);
    const std::string value = valueOf(s.sensor, s.amount);
    switch (s.trouble) {
    case SensorTrouble::Stuck: return stuckWords(s);
    case SensorTrouble::Spikes:
        return fmt::format("{} jumps by {} and back: loose contact?", sensor, value);
    case SensorTrouble::OutOfRange:
        return fmt::format("{} reads {}, which the robot cannot do", sensor, value);
    case SensorTrouble::Flipped:
        return fmt::format("{} changes the wrong way: sign flipped?", sensor);
    case SensorTrouble::SwappedAxles:
        return fmt::format("{} moves when the other axle should: front and rear swapped?", sensor);
    case SensorTrouble::Late:
        return fmt::format("{} still changes by {} after the robot stands still: late?", sensor,
                           value);
    case SensorTrouble::NoLoad:
        return fmt::format("{} feels nothing while the flippers press: disconnected?", sensor);
    case SensorTrouble::LoadedFree:
        return fmt::format("{} reads {} or more while nothing presses: drifted?", sensor, value);
    case SensorTrouble::SidesDiffer:
        return fmt::format("{} differs from the other side by {} at every press", sensor, value);
    case SensorTrouble::Offset:
        return fmt::format("{} does not agree with the ground driven over: offset?", sensor);
    }
    throw std::invalid_argument("describe: no such SensorTrouble");
}

}  // namespace terratact
