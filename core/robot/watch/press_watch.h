#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Judges sensors by what a press of the front flippers must do to them:
///   angles    the front ones fall and the rear ones stay; once the flippers are pressed, none moves
///   currents  of the front are positive once the flippers rest on something, and then stay
///   forces    carry a share of the motors' torque: Σ F_e s_e against k I, s_e from the pivot along the edge; then stay
///   odometry  stays while they press
///   pitch     stays once the flippers are pressed: the sum over presses of the squared change, in noise
/// Of a press that found no ground, and of one that ends within kSettle, less is said.  No clock.
class PressWatch {
public:
    static constexpr double kSettle = 0.6;   ///< [s] of standing after which all is at rest
    static constexpr double kWatched = 1.2;  ///< [s] of a press that are looked at
    static constexpr double kHold = 600.0;   ///< [s] suspected for, unless another press clears it

    explicit PressWatch(const RobotModel& robot);
    void take(const Measurement& line);
    const std::vector<SensorSuspicion>& found() const { return found_; }  ///< by the last line
    /// Sensors of which a press has just shown that they are sound.
    const std::vector<Sensor>& cleared() const { return cleared_; }
    static bool judges(SensorTrouble trouble);
    void reset();

private:
    /// Means of lines.
    struct Mean {
        std::array<double, kSensors> sum{};
        std::array<int, kSensors> lines{};
        double pitchSquares = 0.0;
        void add(const SensorReadings& readings);
        double of(Sensor sensor) const;  ///< 0 where nothing was measured
        int count(Sensor sensor) const { return lines[indexOf(sensor)]; }
        double pitchVariance() const;
    };
    struct Press {
        Mean reference;                 ///< of the lines before it
        std::optional<double> began;    ///< [m] odometry of its first line
        std::optional<double> pressed;  ///< [s] the first line at rest
        Mean first, early, settled;     ///< that line; the first three; after kSettle
        bool wasJudgedEarly = false, wasJudged = false;
        std::array<bool, kSensors> isSuspect{};
    };
    /// What left less right was at the last presses.
    using Differences = std::deque<double>;

    void follow(const Measurement& line, const SensorReadings& readings);
    void judgeMotion(double now);
    void judgeEarly(double now);
    void judgeCurrents(double now);
    void judgeForces(double now);
    void judgeSettled(double now);
    void judgePitch(double now);
    void judgeSides(double now);
    void suspect(Sensor sensor, SensorTrouble trouble, double now, double amount);
    double rise(Sensor angle) const;  ///< [rad] from the reference to the first line at rest
    bool foundGround() const;

    RobotModel robot_;
    std::deque<SensorReadings> before_;  ///< the last lines that are none of a press
    std::optional<Press> press_;
    RobotActivity activity_ = RobotActivity::Halted;
    int swappedPresses_ = 0;                  ///< one after another
    std::deque<double> pitchChanges_;         ///< squared, in noise
    std::array<Differences, 4> differences_;  ///< front and rear angles, front and rear currents
    std::vector<SensorSuspicion> found_;
    std::vector<Sensor> cleared_;
};

}  // namespace terratact
