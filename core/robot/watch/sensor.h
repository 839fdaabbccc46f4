#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/message.h"
#include "core/robot/angles_and_currents.h"
#include "core/robot/measurement.h"

namespace terratact {

/// One reading of a line of telemetry.
enum class Sensor : std::uint8_t {
    TERRATACT_ANGLES_AND_CURRENTS,
    Force1,  ///< mean of left and right
    Force2,
    Force3,
    Force4,
    Force5,
    Force6,
    Travelled,
    LeftForce1,
    LeftForce2,
    LeftForce3,
    LeftForce4,
    LeftForce5,
    LeftForce6,
    RightForce1,
    RightForce2,
    RightForce3,
    RightForce4,
    RightForce5,
    RightForce6,
};
inline constexpr std::size_t kSensors = 29;
using SensorReadings = std::array<std::optional<double>, kSensors>;  ///< SI units, by Sensor

/// Sensors of one kind measure the same quantity and have the same kind of noise.
enum class SensorKind : std::uint8_t { Attitude, Angle, Current, Force, Way };

constexpr std::size_t indexOf(Sensor sensor)
{
    return static_cast<std::size_t>(sensor);
}
constexpr Sensor sensorAt(std::size_t index)
{
    return static_cast<Sensor>(index);
}
SensorKind kindOf(Sensor sensor);

/// These return the mean of element `e` (0 … 5), or that element of one side.
constexpr Sensor meanForce(std::size_t e)
{
    return sensorAt(indexOf(Sensor::Force1) + e);
}
constexpr Sensor leftForce(std::size_t e)
{
    return sensorAt(indexOf(Sensor::LeftForce1) + e);
}
constexpr Sensor rightForce(std::size_t e)
{
    return sensorAt(indexOf(Sensor::RightForce1) + e);
}
constexpr bool isMeanForce(Sensor sensor)
{
    return sensor >= Sensor::Force1 && sensor <= Sensor::Force6;
}
constexpr bool isSideForce(Sensor sensor)
{
    return sensor >= Sensor::LeftForce1;
}
/// Returns the number of the element of a force, 0 … 5.
constexpr std::size_t elementOf(Sensor force)
{
    const Sensor first = isMeanForce(force)          ? Sensor::Force1
                       : force < Sensor::RightForce1 ? Sensor::LeftForce1
                                                     : Sensor::RightForce1;
    return indexOf(force) - indexOf(first);
}

/// Returns a name such as "pitch angle", "front left flipper angle", "rear right flipper current",
/// "left force 3" or "track odometry".
SourceText describe(Sensor sensor);

/// Returns the readings of a line; empty where the robot did not measure. Forces are the means, and
/// the sides where they are known.
SensorReadings readingsOf(const Measurement& line);

/// Returns readingsOf() without the means whose sides are known. Each of these sensors is judged by
/// itself.
SensorReadings judgedReadings(const Measurement& line);

/// Sets one reading. A sensor that did not measure stays so. A mean follows its sides, but a side
/// does not follow its mean.
void setReading(Measurement& line, Sensor sensor, double value);

}  // namespace terratact
