#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/robot/watch/sensor.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Sensors that have not changed by one count, although they should have:
///   attitude  for kMinLines lines and 1 s, in which the tracks moved 0.1 m or a flipper 0.2 rad
///   angles    for 3 s of standing in which another angle changed in every second line, by noise; or, in front,
///             through 0.6 s of pressing
///   currents  for 3 s of standing in which another current did; or from the drive to the press
///   forces    between 0 and the end of their range, from the drive to the press, while another changed by 3 N
///   odometry  for 3 s of driving with resting flippers in which pitch changed by 0.1 rad, or for 10 s;
///             not while the robot turns on the spot
/// A roll that has been exactly 0 since the first line is one that the robot does not measure.
class StuckWatch {
public:
    static constexpr int kMinLines = 20;
    static constexpr double kHold = 10.0;  ///< [s] suspected for, once it changes again

    void take(const Measurement& line);
    const std::vector<SensorSuspicion>& found() const { return found_; }  ///< by the last line

private:
    /// What went on since a sensor last changed.
    struct Run {
        double value = 0.0, since = 0.0;
        int lines = 0, standingLines = 0, pressingLines = 0;
        double pressing = 0.0, driving = 0.0, standing = 0.0;  ///< [s]
        double way = 0.0, swept = 0.0;                         ///< [m], [rad]
        double least = 0.0, most = 0.0;                        ///< smoothed pitch [rad]
        bool drove = false, pressed = false;
        std::array<int, kSensors> noisy{};  ///< standing lines in which another changed
        SensorReadings low{}, high{};       ///< of the others
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
    double forceEnd_ = 0.0;  ///< [N] the largest force that came
    bool rollMeasured_ = false;
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
