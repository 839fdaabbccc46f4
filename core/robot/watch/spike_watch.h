#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Readings that jump away and back, and such as the robot cannot have.
///   a spike   one line differs from the one before and the one after, both the same way, by more than
///             0.1 rad, 1.5 A, 6 N, 0.1 m; of currents and forces while the robot stands.  kSpikes of them in kWindow.
///   range     |pitch|, |roll| above 1.5 rad; a current above twice that of the motor's largest torque;
///             odometry faster than 1.5 m/s, but for a return to 0: its robot began anew
/// Angles are wrapped and forces end at their largest value, so that neither can leave its range.
class SpikeWatch {
public:
    static constexpr int kSpikes = 3;
    static constexpr double kWindow = 10.0;  ///< [s]
    static constexpr double kHold = 30.0;    ///< [s] suspected for, after the last

    explicit SpikeWatch(const RobotModel& robot);
    void take(const Measurement& line);
    const std::vector<SensorSuspicion>& found() const { return found_; }  ///< by the last line
    void reset();

private:
    void lookForSpike(std::size_t sensor, const Measurement& line, const SensorReadings& readings);
    void lookAtRange(const Measurement& line, const SensorReadings& readings);
    void suspect(Sensor sensor, SensorTrouble trouble, double now, double amount);

    double currentLimit_;
    std::optional<Measurement> before_, beforeThat_;
    std::array<std::deque<double>, kSensors> spikes_;  ///< [s] when
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
