#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Checks sensors against the effects of a press of the front flippers:
///   angles    The front angles fall and the rear angles stay. Once the flippers are pressed, none moves.
///   currents  The front currents are positive once the flippers rest on something, and then stay.
///   forces    They carry a share of the motors' torque, and then stay: Σ F_e s_e against k I, with s_e
///             the distance from the pivot along the edge.
///   odometry  It does not change during a press.
///   pitch     It stays once the flippers are pressed. The rule sums the squared changes over several
///             presses, in units of noise.
/// Fewer rules apply to a press that found no ground, and to one that ends within kSettle. A current
/// that was not measured is not judged. Forces are compared with the torque only if all are measured.
/// A reading that gets lost in a press is not late. The watch has no clock.
/// Forces are the means of left and right.
class PressWatch {
public:
    static constexpr double kSettle = 0.6;   ///< [s] of standing after which everything is at rest
    static constexpr double kWatched = 1.2;  ///< [s] length of a press that is evaluated
    /// [s] duration of a suspicion, unless another press clears it
    static constexpr double kHold = 600.0;

    explicit PressWatch(const RobotModel& robot);
    void add(const Measurement& line);
    /// Suspicions of the last line.
    const std::vector<SensorSuspicion>& found() const { return found_; }
    /// Returns the sensors that passed the checks of the last press.
    const std::vector<Sensor>& cleared() const { return cleared_; }
    static bool judges(SensorTrouble trouble);
    void reset();

private:
    /// Means over lines.
    struct Mean {
        std::array<double, kSensors> sum{};
        std::array<int, kSensors> lines{};
        double pitchSquares = 0.0;
        void add(const SensorReadings& readings);
        double of(Sensor sensor) const;  ///< 0 if nothing was measured
        int count(Sensor sensor) const { return lines[indexOf(sensor)]; }
        double pitchVariance() const;
    };
    struct Press {
        Mean reference;                 ///< lines before the press
        std::optional<double> began;    ///< odometry of its first line [m]
        std::optional<double> pressed;  ///< time of the first line at rest [s]
        Mean first, early, settled;     ///< the first line at rest; the first three; after kSettle
        bool wasJudgedEarly = false, wasJudged = false;
        std::array<bool, kSensors> isSuspect{};
    };
    /// Left minus right at the latest presses.
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
    /// A front angle rises. The other one rises, too, or was its mirror image before the press: both
    /// flippers are held alike. A flipper that an obstacle on one side lifts does not look flipped.
    bool looksFlipped(Sensor front) const;
    double rise(Sensor angle) const;  ///< change from the reference to the first line at rest [rad]
    bool foundGround() const;

    RobotModel robot_;
    std::deque<SensorReadings> before_;  ///< the latest lines outside of a press
    std::optional<Press> press_;
    RobotActivity activity_ = RobotActivity::Halted;
    int swappedPresses_ = 0;                  ///< consecutive presses that look swapped
    std::deque<double> pitchChanges_;         ///< squared, in units of noise
    std::array<Differences, 4> differences_;  ///< front and rear angles, front and rear currents
    std::vector<SensorSuspicion> found_;
    std::vector<Sensor> cleared_;
};

}  // namespace terratact
