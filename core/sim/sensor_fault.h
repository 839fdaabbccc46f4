#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor.h"

namespace terratact {

/// Kind of a sensor fault.
enum class FaultKind : std::uint8_t {
    Stuck,         ///< keeps its value from the begin of the fault
    StuckAtScene,  ///< keeps its value from the last press of the flippers
    Zero,          ///< reads 0
    Offset,        ///< reads `amount` too much
    Drift,         ///< reads `amount` per minute too much since the fault began
    Spikes,        ///< `amount` more or less in one line of four
    Scatter,       ///< `amount` more or less in every line
    Flipped,       ///< has the other sign
    Swapped,       ///< left and right of each axle exchanged; forces: 1 and 6, 2 and 5, 3 and 4
    SwappedAxles,  ///< front and rear exchanged
    Late,          ///< reads its value of `amount` seconds before
    OutOfRange,    ///< reads twice the limit of its kind, which the robot cannot reach
    FullScale,     ///< reads the end of its range
    Lost           ///< has no reading, and telemetry says so
};

/// A fault of one or several sensors.
struct SensorFault {
    FaultKind kind = FaultKind::Stuck;
    std::vector<Sensor> sensors;
    double amount = 0.0;  ///< in SI units of the sensor; seconds for Late
};

/// Returns the fault of "KIND:SENSORS" or "KIND:SENSORS:AMOUNT", such as "stuck:pitch",
/// "offset:front:0.17", "late:all:0.5".
///   KIND     stuck, stuck-at-scene, zero, offset, drift, spikes, scatter, flipped, swapped,
///            swapped-axles, late, out-of-range, full-scale, lost
///   SENSORS  pitch, roll, attitude, front, rear, front-left …, front-current, rear-current, front-left-current …,
///            currents, angles, forces, force-1 … force-6, odometry, all; forces of one side:
///            left-forces, right-force-1, …
/// Default AMOUNT: 10° for angles and attitude, 1 A, 3 N, 1 m; a tenth of that for a drift; 0.5 s
/// for Late. Lost leaves out attitude and angles, without which there is no line of telemetry. Empty if
/// the text is none of these, or leaves no sensor. `simulate --disturb` and `robot --fault` take such
/// texts.
std::optional<SensorFault> sensorFaultFrom(std::string_view text);

/// Returns the explanation of such a text for --help and errors.
std::string sensorFaultSyntax();

/// Converts lines of telemetry to those of a robot with the fault. The robot itself moves as
/// without it. Deterministic for a seed; keeps at most 10 s of lines.
class FaultySensors {
public:
    FaultySensors(SensorFault fault, const RobotModel& robot, std::uint64_t seed);

    /// Returns the next line with the fault. Lines must come in order of time. A fault of a force is
    /// one of both sides if they are known, and the mean follows them. If only the mean is known, it
    /// has half of a fault of one side; if that side is lost, it stays.
    Measurement apply(const Measurement& truth);

private:
    double push();
    double faulty(Sensor sensor, double value, const Measurement& truth, double push) const;
    double late(Sensor sensor, double value) const;
    void swap(Measurement& line, const Measurement& truth) const;
    double limitOf(Sensor sensor) const;
    void keepScene(const Measurement& truth);

    SensorFault fault_;
    double forceSaturation_ = 0.0, currentLimit_ = 0.0;
    std::mt19937_64 rng_;
    std::optional<Measurement> first_, atScene_, nextScene_;
    std::deque<Measurement> past_;  ///< for Late
    RobotActivity before_ = RobotActivity::Halted;
};

/// Converts scenes without telemetry between them to those of a robot with the fault. It applies
/// FaultySensors to the scene with left equal to right. Late changes the front flippers only,
/// because only they moved just before a scene. They were higher by `amount` seconds of their
/// speed.
class FaultyScenes {
public:
    FaultyScenes(SensorFault fault, const RobotModel& robot, std::uint64_t seed);
    Proprioception apply(const Proprioception& scene, double time);

private:
    SensorFault fault_;
    double flipperSpeed_ = 0.0;
    FaultySensors sensors_;
};

}  // namespace terratact
