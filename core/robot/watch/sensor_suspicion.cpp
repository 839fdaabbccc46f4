#include "core/robot/watch/sensor_suspicion.h"

#include <algorithm>
#include <stdexcept>

namespace terratact {
namespace {

constexpr double kNotableWay = 0.05;  // [m]

Message stuckMessage(const SensorSuspicion& s)
{
    if (s.way >= kNotableWay)
        return {TR_NOOP("core", "not changed for %1 s while the robot drove %2 m, stuck?"),
                fixed(s.amount, 0), fixed(s.way, 1)};
    return {TR_NOOP("core", "not changed for %1 s, not even by noise, stuck?"), fixed(s.amount, 0)};
}

}  // namespace

SensorSuspicion suspicionFor(double seconds, Sensor sensor, SensorTrouble trouble, double now,
                             double amount)
{
    return {.sensor = sensor,
            .trouble = trouble,
            .since = now,
            .until = now + seconds,
            .amount = amount,
            .way = 0.0};
}

bool isSuspected(const std::vector<SensorSuspicion>& suspicions, Sensor sensor)
{
    return std::any_of(suspicions.begin(), suspicions.end(),
                       [sensor](const SensorSuspicion& s) { return s.sensor == sensor; });
}

bool isWaySuspected(const std::vector<SensorSuspicion>& suspicions)
{
    return isSuspected(suspicions, Sensor::Travelled) || isSuspected(suspicions, Sensor::Pitch);
}

Message describeTrouble(const SensorSuspicion& s)
{
    switch (s.trouble) {
    case SensorTrouble::Stuck: return stuckMessage(s);
    case SensorTrouble::Spikes: return TR_NOOP("core", "jumps away and comes back, loose contact?");
    case SensorTrouble::OutOfRange: return TR_NOOP("core", "reads what the robot cannot do");
    case SensorTrouble::Flipped: return TR_NOOP("core", "changes the wrong way, sign flipped?");
    case SensorTrouble::SwappedAxles:
        return TR_NOOP("core", "moves with the other axle, front and rear swapped?");
    case SensorTrouble::Late:
        return TR_NOOP("core", "still changes when the robot stands still, late?");
    case SensorTrouble::NoLoad:
        return TR_NOOP("core", "no load while the flippers press, disconnected?");
    case SensorTrouble::LoadedFree:
        return TR_NOOP("core", "loaded while nothing presses, drifted?");
    case SensorTrouble::SidesDiffer:
        return TR_NOOP("core", "left and right differ by the same at every press");
    case SensorTrouble::OffGround:
        return TR_NOOP("core", "does not fit the ground driven over, offset or sign flipped?");
    case SensorTrouble::WrongOrder:
        return TR_NOOP("core", "load where no ground was, order reversed?");
    case SensorTrouble::BothWays:
        return TR_NOOP("core",
                       "does not fit the same ground driven in both directions, zero shifted?");
    }
    throw std::invalid_argument("describe: no such SensorTrouble");
}

Message describe(const SensorSuspicion& s)
{
    return Message::joined(describe(s.sensor), describeTrouble(s));
}

}  // namespace terratact
