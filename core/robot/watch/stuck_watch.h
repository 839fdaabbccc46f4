#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"
#include "core/robot/watch/sensor.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Detects sensors that have not changed by one count for kMinLines lines, although they should have:
///   attitude  while the tracks moved 0.1 m or a flipper 0.2 rad
///   angles    for 3 s of standing in which noise changed another angle in every second line; for the
///             front angles also through 0.6 s of pressing
///   currents  for 3 s of standing in which noise changed another current; or from drive to press
///   forces    between 0 and the end of their range, from drive to press, while another changed by 3 N
///   odometry  for 3 s of driving with resting flippers in which pitch changed by 0.1 rad, or for 10 s;
///             not while the robot turns on the spot
/// A roll that has been exactly 0 since the first line counts as not measured.
class StuckWatch {
public:
    static constexpr int kMinLines = 20;
    /// [s] duration of a suspicion once the reading changes again
    static constexpr double kHold = 10.0;

    void add(const Measurement& line);
    /// Suspicions of the last line.
    const std::vector<SensorSuspicion>& found() const { return found_; }

private:
    /// Motion of the robot since a sensor last changed.
    struct Run {
        double value = 0.0, since = 0.0;
        int lines = 0, standingLines = 0, pressingLines = 0;
        double pressing = 0.0, driving = 0.0, standing = 0.0;  ///< [s]
        double way = 0.0, swept = 0.0;                         ///< [m], [rad]
        double least = 0.0, most = 0.0;                        ///< smoothed pitch [rad]
        bool drove = false, pressed = false;
        std::array<int, kSensors> noisy{};  ///< standing lines in which another sensor changed
        SensorReadings low{}, high{};       ///< range of the other sensors
    };
    void follow(Run& run, const Measurement& line, const SensorReadings& readings, double dt);
    bool isStuck(Sensor sensor, const Run& run) const;
    bool likeIsNoisy(Sensor sensor, const Run& run) const;
    bool otherForceMoved(Sensor sensor, const Run& run) const;

    std::optional<Measurement> before_;
    SensorReadings last_{};
    std::array<Run, kSensors> runs_{};
    double smoothPitch_ = 0.0;
    double smoothFront_ = 0.0, smoothRear_ = 0.0;
    double forceEnd_ = 0.0;  ///< largest force so far [N]
    bool rollMeasured_ = false;
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
