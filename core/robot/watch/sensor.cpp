#include "core/robot/watch/sensor.h"

#include <stdexcept>

#include "core/base/message.h"

namespace terratact {
namespace {

constexpr std::size_t kFirstForce = indexOf(Sensor::Force1);
constexpr std::array kNames{TR_NOOP("core", "pitch angle"),
                            TR_NOOP("core", "roll angle"),
                            TR_NOOP("core", "front left flipper angle"),
                            TR_NOOP("core", "front right flipper angle"),
                            TR_NOOP("core", "rear left flipper angle"),
                            TR_NOOP("core", "rear right flipper angle"),
                            TR_NOOP("core", "front left flipper current"),
                            TR_NOOP("core", "front right flipper current"),
                            TR_NOOP("core", "rear left flipper current"),
                            TR_NOOP("core", "rear right flipper current"),
                            TR_NOOP("core", "force 1"),
                            TR_NOOP("core", "force 2"),
                            TR_NOOP("core", "force 3"),
                            TR_NOOP("core", "force 4"),
                            TR_NOOP("core", "force 5"),
                            TR_NOOP("core", "force 6"),
                            TR_NOOP("core", "track odometry")};
static_assert(kNames.size() == kSensors);

/// Returns pitch to rear right current, in the order of Sensor.
template <class Line>
auto plainReadings(Line& m)
{
    return std::array{&m.pitch,
                      &m.roll,
                      &m.frontLeft,
                      &m.frontRight,
                      &m.rearLeft,
                      &m.rearRight,
                      &m.frontLeftCurrent,
                      &m.frontRightCurrent,
                      &m.rearLeftCurrent,
                      &m.rearRightCurrent};
}

}  // namespace

SensorKind kindOf(Sensor sensor)
{
    if (sensor <= Sensor::Roll) return SensorKind::Attitude;
    if (sensor <= Sensor::RearRight) return SensorKind::Angle;
    if (sensor <= Sensor::RearRightCurrent) return SensorKind::Current;
    if (sensor <= Sensor::Force6) return SensorKind::Force;
    return SensorKind::Way;
}

std::string_view describe(Sensor sensor)
{
    return kNames.at(indexOf(sensor)).english;
}

SensorReadings readingsOf(const Measurement& m)
{
    SensorReadings readings;
    const auto plain = plainReadings(m);
    for (std::size_t i = 0; i < plain.size(); ++i) readings[i] = *plain[i];
    for (std::size_t e = 0; e < m.force.size(); ++e) readings[kFirstForce + e] = m.force[e];
    readings[indexOf(Sensor::Travelled)] = m.travelled;
    return readings;
}

void setReading(Measurement& m, Sensor sensor, double value)
{
    const std::size_t i = indexOf(sensor);
    const auto plain = plainReadings(m);
    if (i < plain.size())
        *plain[i] = value;
    else if (sensor != Sensor::Travelled)
        m.force.at(i - kFirstForce) = value;
    else if (m.travelled)
        m.travelled = value;
}

}  // namespace terratact
