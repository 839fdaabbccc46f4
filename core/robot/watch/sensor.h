#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/robot/measurement.h"

namespace terratact {

/// One reading of a line of telemetry.
enum class Sensor : std::uint8_t {
    Pitch,
    Roll,
    FrontLeft,
    FrontRight,
    RearLeft,
    RearRight,
    FrontLeftCurrent,
    FrontRightCurrent,
    RearLeftCurrent,
    RearRightCurrent,
    Force1,
    Force2,
    Force3,
    Force4,
    Force5,
    Force6,
    Travelled,
};
inline constexpr std::size_t kSensors = 17;
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

/// Returns a name such as "pitch angle", "front left flipper angle", "rear right flipper current",
/// "force 3" or "track odometry".
std::string_view describe(Sensor sensor);

/// Returns all readings; empty where the robot did not measure.
SensorReadings readingsOf(const Measurement& measurement);

/// Sets one reading. A sensor that did not measure stays empty.
void setReading(Measurement& measurement, Sensor sensor, double value);

}  // namespace terratact
