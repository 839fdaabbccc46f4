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

/// How a sensor lies.
enum class FaultKind : std::uint8_t {
    Stuck,         ///< stays what it was when the fault began
    StuckAtScene,  ///< shows what it measured when the flippers were last pressed; renewed at every press
    Zero,          ///< reads 0
    Offset,        ///< reads `amount` more
    Drift,         ///< reads `amount` more per minute since the fault began
    Spikes,        ///< `amount` more or less in one line of four
    Scatter,       ///< `amount` more or less in every line
    Flipped,       ///< has the other sign
    Swapped,       ///< left and right of each axle; forces: 1 and 6, 2 and 5, 3 and 4
    SwappedAxles,  ///< front and rear
    Late,          ///< shows what it measured `amount` seconds before
    OutOfRange,    ///< reads what the robot cannot do: twice the limit of its kind
    FullScale      ///< reads the end of its range
};

/// A fault of some sensors.
struct SensorFault {
    FaultKind kind = FaultKind::Stuck;
    std::vector<Sensor> sensors;
    double amount = 0.0;  ///< SI units of the sensor; [s] of Late
    /// Of force elements: those of one side alone, so that the mean of both sides has half of the fault.
    bool isOfOneSide = false;
};

/// "KIND:SENSORS" or "KIND:SENSORS:AMOUNT", e.g. "stuck:pitch", "offset:front:0.17", "late:all:0.5".
///   KIND     stuck, stuck-at-scene, zero, offset, drift, spikes, scatter, flipped, swapped, swapped-axles, late,
///            out-of-range, full-scale
///   SENSORS  pitch, roll, front, rear, front-left …, front-current, rear-current, front-left-current …, currents,
///            angles, forces, force-1 … force-6, odometry, all; forces of one side: left-forces, right-force-1, …
/// Without AMOUNT: 10° of angles and attitude, 1 A, 3 N, 1 m; a tenth of that of a drift; 0.5 s of Late.
/// Empty where the text is none of these.
std::optional<SensorFault> sensorFaultFrom(std::string_view text);

/// What --help and an error say of such a text.
std::string sensorFaultSyntax();

/// Lines of telemetry as a robot with that fault sends them.  The robot itself moves as without it.
/// Deterministic for a seed; keeps at most 10 s of lines.
class FaultySensors {
public:
    FaultySensors(SensorFault fault, const RobotModel& robot, std::uint64_t seed);

    /// The next line, in order of time.
    Measurement take(const Measurement& truth);

private:
    double faulty(Sensor sensor, double value, const Measurement& truth);
    double late(Sensor sensor, double value) const;
    double ofBothSides(double truth, double wrong) const;
    void swap(Measurement& m, const Measurement& truth) const;
    double limitOf(Sensor sensor) const;
    void keepScene(const Measurement& truth);

    SensorFault fault_;
    double forceSaturation_ = 0.0, currentLimit_ = 0.0;
    std::mt19937_64 rng_;
    std::optional<Measurement> first_, atScene_, nextScene_;
    std::deque<Measurement> past_;  ///< of Late
    RobotActivity before_ = RobotActivity::Halted;
};

/// A scene as such a sensor gives it, for scenes without telemetry between them: FaultySensors of the scene with
/// left equal to right.  Late changes the front flippers alone, the only part that moved just before a scene:
/// they were higher by `amount` seconds of their speed.
class FaultyScenes {
public:
    FaultyScenes(SensorFault fault, const RobotModel& robot, std::uint64_t seed);
    Proprioception take(const Proprioception& scene, double time);

private:
    SensorFault fault_;
    double flipperSpeed_ = 0.0;
    FaultySensors sensors_;
};

}  // namespace terratact
