#include "core/robot/watch/sensor.h"

#include <stdexcept>

#include "core/base/message.h"

namespace terratact {
namespace {

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
                            TR_NOOP("core", "track odometry"),
                            TR_NOOP("core", "left force 1"),
                            TR_NOOP("core", "left force 2"),
                            TR_NOOP("core", "left force 3"),
                            TR_NOOP("core", "left force 4"),
                            TR_NOOP("core", "left force 5"),
                            TR_NOOP("core", "left force 6"),
                            TR_NOOP("core", "right force 1"),
                            TR_NOOP("core", "right force 2"),
                            TR_NOOP("core", "right force 3"),
                            TR_NOOP("core", "right force 4"),
                            TR_NOOP("core", "right force 5"),
                            TR_NOOP("core", "right force 6")};
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

/// Returns true for a current, or the mean of a force, that was not measured.
bool lacksReading(const Measurement& line, Sensor sensor)
{
    if (isMeanForce(sensor)) return line.missing[kFirstForceFeature + elementOf(sensor)];
    return kindOf(sensor) == SensorKind::Current
        && !motorCurrents(line)[indexOf(sensor) - indexOf(Sensor::FrontLeftCurrent)];
}

void setSide(Measurement& line, Sensor sensor, double value)
{
    const std::size_t e = elementOf(sensor);
    auto& side = sensor < Sensor::RightForce1 ? line.sides.left[e] : line.sides.right[e];
    if (!side) return;
    side = value;
    const double left = line.sides.left[e].value_or(value);
    line.force[e] = (left + line.sides.right[e].value_or(value)) / 2.0;
}

}  // namespace

SensorKind kindOf(Sensor sensor)
{
    if (sensor <= Sensor::Roll) return SensorKind::Attitude;
    if (sensor <= Sensor::RearRight) return SensorKind::Angle;
    if (sensor <= Sensor::RearRightCurrent) return SensorKind::Current;
    return sensor == Sensor::Travelled ? SensorKind::Way : SensorKind::Force;
}

SourceText describe(Sensor sensor)
{
    return kNames.at(indexOf(sensor));
}

SensorReadings readingsOf(const Measurement& m)
{
    SensorReadings readings;
    const auto plain = plainReadings(m);
    for (std::size_t i = 0; i < plain.size(); ++i)
        if (!lacksReading(m, sensorAt(i))) readings[i] = *plain[i];
    for (std::size_t e = 0; e < m.force.size(); ++e) {
        if (!lacksReading(m, meanForce(e))) readings[indexOf(meanForce(e))] = m.force[e];
        readings[indexOf(leftForce(e))] = m.sides.left[e];
        readings[indexOf(rightForce(e))] = m.sides.right[e];
    }
    readings[indexOf(Sensor::Travelled)] = m.travelled;
    return readings;
}

SensorReadings judgedReadings(const Measurement& line)
{
    SensorReadings readings = readingsOf(line);
    for (std::size_t e = 0; e < kForceElements; ++e)
        if (line.sides.knows(e)) readings[indexOf(meanForce(e))].reset();
    return readings;
}

void setReading(Measurement& m, Sensor sensor, double value)
{
    if (lacksReading(m, sensor)) return;
    const std::size_t i = indexOf(sensor);
    const auto plain = plainReadings(m);
    if (i < plain.size()) {
        *plain[i] = value;
    } else if (sensor == Sensor::Travelled) {
        if (m.travelled) m.travelled = value;
    } else if (isMeanForce(sensor)) {
        m.force[elementOf(sensor)] = value;
    } else {
        setSide(m, sensor, value);
    }
}

}  // namespace terratact
