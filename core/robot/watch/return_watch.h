#pragma once

#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/robot/watch/driven_ground.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// A pitch whose zero has shifted, seen where the robot comes back over ground that it passed in the other direction:
/// the ground's slope changes its sign there, the shift does not,
///   shift = ½ (mean θ there + mean θ back) − (kNoseUp − kNoseDown λ),
/// over the same way from where the robot turned.  θ is that of the line that the robot rests on (supportAngle).  A
/// robot that climbs over edges points up for longer than the ground does, since its centre of mass is behind its
/// middle, and down where rear flippers carry it: λ is the share of the way on which they do.  Both constants are of
/// simulated drives over generated ground; over real profiles the same fit has 0.0113 and 0.048, and a residual of
/// 0.012 rad.  In one direction alone no sensor of this robot tells a shift from a slope.
/// Needs the way and the turn of the odometry.  Memory is bounded.  No clock.
class ReturnWatch {
public:
    static constexpr double kStep = 0.1;  ///< [m]
    static constexpr double kNear =
        0.3;  ///< [m] from a place on the way out that counts as the same
    static constexpr double kOpposite = 0.3;  ///< [rad] of the headings, from half a turn
    static constexpr double kMinWay = 2.5;    ///< [m] back
    static constexpr double kNoseUp = 0.0115, kNoseDown = 0.0537;  ///< [rad]
    static constexpr double kLimit =
        0.075;  ///< [rad] of a shift over kLimitWay; over another way times √(kLimitWay / way)
    static constexpr double kLimitWay = 4.0;  ///< [m] back
    static constexpr double kHold = 600.0;    ///< [s] suspected for, unless cleared

    explicit ReturnWatch(const RobotModel& robot) : robot_(robot) {}
    void take(const Measurement& line);
    const std::vector<SensorSuspicion>& found() const { return found_; }  ///< by the last line
    /// The last look is within its limit.
    bool isCleared() const { return shift_ && std::abs(*shift_) < limit_; }
    void reset();

private:
    struct Step {
        Vec2 place;  ///< x along the first heading, z to its left [m]
        double heading = 0.0;
        double pitch = 0.0;   ///< mean over its way [rad]
        double loaded = 0.0;  ///< share of it with loaded rear flippers
    };
    void end(double heading, double now);
    /// Where the steps back, to the newest one, begin.
    std::size_t turnedAt() const;
    std::optional<double> shiftNow() const;  ///< empty: not far enough back
    double wayBack() const;                  ///< [m]

    RobotModel robot_;
    RearLoad rear_;
    std::optional<double> travelled_;
    Vec2 place_;
    double way_ = 0.0, pitchWay_ = 0.0, loadedWay_ = 0.0;  ///< of the step under way
    std::deque<Step> steps_;
    std::optional<double> shift_;  ///< [rad] at the last look
    double limit_ = 0.0;           ///< [rad] of that look
    std::vector<SensorSuspicion> found_;
};

}  // namespace terratact
