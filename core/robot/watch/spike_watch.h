#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Detects readings that jump away and back, and readings that the robot cannot have.
///   spike  One line differs from both neighbours in the same direction: by more than 0.1 rad, 1.5 A,
///          6 N or 0.1 m. Currents and forces count only while the robot stands. kSpikes within kWindow count.
///   range  |pitch| or |roll| is above 1.5 rad. Or a current is above twice that of the motor's largest
///          torque, or odometry is faster than kFastestTracks. A return of odometry to 0 is a restart instead.
/// A force of one side must jump by 0.4 of its size more.
/// Angles are wrapped and forces end at their largest value, so that neither can leave its range.
class SpikeWatch {
public:
    static constexpr int kSpikes = 3;
    static constexpr double kWindow = 10.0;  ///< [s]
    static constexpr double kHold = 30.0;    ///< [s] duration of a suspicion after the last spike

    explicit SpikeWatch(const RobotModel& robot);
    void add(const Measurement& line);
    /// Suspicions of the last line.
    const std::vector<SensorSuspicion>& found() const { return found_; }
    void reset();

private:
    struct Line {
        Measurement measurement;
        SensorReadings readings;
    };
    void detectSpike(std::size_t sensor, const Line& line);
    void checkRange(const Measurement& line, const SensorReadings& readings);
    void suspect(Sensor sensor, SensorTrouble trouble, double now, double amount);

    double currentLimit_;
    std::optional<Line> before_, beforeThat_;
    std::array<std::deque<double>, kSensors> spikes_;  ///< times of the spikes [s]
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
