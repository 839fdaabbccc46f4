#pragma once

#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/robot/watch/driven_ground.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Detects a shifted zero of pitch when the robot returns over ground that it passed in the other
/// direction. The slope of the ground changes its sign there, but the shift does not. At each place
/// of the centre of mass,
///   shift = ½ (θ out + θ back) − bias.
/// θ is the pitch of the line that the robot rests on (supportAngle). The bias is kLoaded where the
/// rear flippers carry a load in both directions. It is kUnloaded where they carry none in either.
/// Other places are left out. So are lines with a load on the front flippers, and lines that lack the
/// currents of an axle. The contacts of a robot on an edge depend on its centre of mass, not on its
/// middle. Slip displaces the places, so the watch takes the mean of the middle half of all shifts.
/// Both biases were fitted to simulated drives over generated ground. In one direction alone no sensor
/// of this robot can distinguish a shift from a slope. The watch needs way and turn of the odometry. Its
/// memory is bounded, and it has no clock.
class ReturnWatch {
public:
    static constexpr double kStep = 0.02;  ///< [m] way of a place
    /// [m] largest distance to the side of a place on the way out that counts as the same
    static constexpr double kNear = 0.2;
    static constexpr double kSame = 0.025;  ///< [m] largest distance along the way
    /// [rad] largest deviation of the headings from half a turn
    static constexpr double kOpposite = 0.3;
    static constexpr std::size_t kMinPlaces =
        40;  ///< least number of places passed in both directions
    static constexpr std::size_t kMaxPlaces = 400;  ///< only the newest are kept
    static constexpr double kMinWay = 2.5;          ///< [m] least way since the first of them
    static constexpr double kUnloaded = 0.0055, kLoaded = -0.0095;  ///< [rad] bias
    /// [rad] limit of the shift over n places: kLimit + kLimitOfOne / √n
    static constexpr double kLimit = 0.03, kLimitOfOne = 0.06;
    static constexpr double kHold = 600.0;  ///< [s] duration of a suspicion, unless it is cleared

    explicit ReturnWatch(const RobotModel& robot) : robot_(robot) {}
    void add(const Measurement& line);
    /// Suspicions of the last line.
    const std::vector<SensorSuspicion>& found() const { return found_; }
    /// Returns the latest shift [rad]; empty: too few places were passed in both directions.
    std::optional<double> shift() const { return shift_; }
    std::size_t places() const { return shifts_.size(); }
    /// Returns true if the last shift is within its limit.
    bool isCleared() const { return shift_ && std::abs(*shift_) < limit(); }
    void reset();

private:
    enum class Load { None, Some, All };
    struct Step {
        Vec2 place;  ///< centre of mass; x along the first heading, z to its left [m]
        double heading = 0.0;
        double pitch = 0.0;  ///< mean over the step [rad]
        Load load = Load::None;
    };
    void end(double heading, double now);
    double limit() const { return kLimit + kLimitOfOne / std::sqrt(static_cast<double>(places())); }
    /// Returns the same place, passed in the other direction with the same load, or nullptr.
    const Step* opposite(const Step& step) const;
    double middleMean() const;

    RobotModel robot_;
    RearLoad rear_;
    std::optional<double> travelled_;
    Vec2 place_;                                           ///< middle of the robot
    double way_ = 0.0, pitchWay_ = 0.0, loadedWay_ = 0.0;  ///< sums over the current step
    std::deque<Step> steps_;
    std::deque<double> shifts_;             ///< shifts of single places [rad]
    std::optional<double> firstTravelled_;  ///< odometry at the first place [m]
    std::optional<double> shift_;           ///< latest value [rad]
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
