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
/// direction. The slope of the ground changes its sign there, but the shift does not:
///   shift = ½ (mean θ out + mean θ back) − (kNoseUp − kNoseDown λ)
/// Both means are over the same way from the point where the robot turned. θ is the pitch of the
/// line that the robot rests on (supportAngle). λ is the share of the way on which rear flippers
/// carry a load. A robot that climbs over edges points up for longer than the ground does: its
/// centre of mass lies behind its middle. Loaded rear flippers make it point down. kNoseUp and
/// kNoseDown were fitted to simulated drives over generated ground. Over real profiles the same fit
/// gives 0.0113 and 0.048, with a residual of 0.012 rad. In one direction alone no sensor of this
/// robot can tell a shift from a slope.
/// The watch needs way and turn of the odometry. Its memory is bounded, and it has no clock.
class ReturnWatch {
public:
    static constexpr double kStep = 0.1;  ///< [m]
    /// [m] largest distance of a place on the way out that counts as the same.
    static constexpr double kNear = 0.3;
    /// [rad] largest deviation of the headings from half a turn
    static constexpr double kOpposite = 0.3;
    static constexpr double kMinWay = 2.5;                         ///< [m] least way back
    static constexpr double kNoseUp = 0.0115, kNoseDown = 0.0537;  ///< [rad]
    /// Limit of the shift [rad] over kLimitWay. Over another way it is kLimit √(kLimitWay / way).
    static constexpr double kLimit = 0.075;
    static constexpr double kLimitWay = 4.0;  ///< [m] way back
    static constexpr double kHold = 600.0;    ///< [s] duration of a suspicion, unless it is cleared

    explicit ReturnWatch(const RobotModel& robot) : robot_(robot) {}
    void take(const Measurement& line);
    /// Suspicions of the last line.
    const std::vector<SensorSuspicion>& found() const { return found_; }
    /// Returns true if the last shift is within its limit.
    bool isCleared() const { return shift_ && std::abs(*shift_) < limit_; }
    void reset();

private:
    struct Step {
        Vec2 place;  ///< x along the first heading, z to its left [m]
        double heading = 0.0;
        double pitch = 0.0;   ///< mean over the step [rad]
        double loaded = 0.0;  ///< share of the step with loaded rear flippers
    };
    void end(double heading, double now);
    /// Returns the index of the first step of the way back.
    std::size_t turnedAt() const;
    std::optional<double> shiftNow() const;  ///< empty: not far enough back
    double wayBack() const;                  ///< [m]

    RobotModel robot_;
    RearLoad rear_;
    std::optional<double> travelled_;
    Vec2 place_;
    double way_ = 0.0, pitchWay_ = 0.0, loadedWay_ = 0.0;  ///< sums over the current step
    std::deque<Step> steps_;
    std::optional<double> shift_;  ///< latest value [rad]
    double limit_ = 0.0;           ///< limit for that value [rad]
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
