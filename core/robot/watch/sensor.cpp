#include "core/robot/watch/sensor.h"

#include <stdexcept>

namespace terratact {
namespace {

constexpr std::size_t kFirstForce = indexOf(Sensor::Force1);
constexpr std::array kNames{"pitch angle",
                            "roll angle",
                            "front left flipper angle",
                            "front right flipper angle",
                            "rear left flipper angle",
                            "rear right flipper angle",
                            "front left flipper current",
                            "front right flipper current",
                            "rear left flipper current",
                            "rear right flipper current",
                            "force 1",
                            "force 2",
                            "force 3",
                            "force 4",
                            "force 5",
                            "force 6",
                            "track odometry"};
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
    return kNames.at(indexOf(sensor));
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
