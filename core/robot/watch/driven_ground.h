#pragma once

#include <map>
#include <optional>

#include "core/robot/kinematics.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Mean current of the rear flippers, smoothed: whether they carry a load.
class RearLoad {
public:
    static constexpr double kLoaded = 0.4;  ///< [A] per motor
    void take(const Measurement& line);
    double current() const { return current_; }  ///< [A]
    bool isLoaded() const { return current_ > kLoaded; }

private:
    double current_ = 0.0;
};

/// The angle [rad] from the tracks up to the line that the robot rests on when its rear flippers carry a load: the
/// tangent from below to the front track wheel and the rear flippers' tips.  0 where the tips are above the tracks.
double supportAngle(const RobotModel& robot, double rear);

/// The ground that the tracks have passed over, as far as they tell: no ground is higher than the lowest position of
/// the tracks above it, and most high spots have carried them.  In a frame along gravity that begins with the first
/// line, by dead reckoning: a way ds along the tracks moves the robot along the line that it rests on,
///   ds / cos β · (cos(θ + β), sin(θ + β)),  β supportAngle() while the rear flippers carry a load, else 0,
/// and the robot turns about the point of its tracks' lower edge below its centre of mass.
/// Remembers kKept to both sides.  No clock.
class DrivenGround {
public:
    static constexpr double kCell = 0.02;  ///< [m]
    static constexpr double kKept = 3.0;   ///< [m]

    explicit DrivenGround(const RobotModel& robot);

    /// The next line.  Does nothing where the way is not measured.
    void take(const Measurement& line, bool isRearLoaded);

    /// Of the last line, left and right averaged.
    const Pose& pose() const { return pose_; }
    /// As pose(), with another pitch and another angle of the front flippers.
    Pose poseWith(double pitch, double front) const;
    bool hasMoved() const { return moved_; }       ///< forwards, at the last line
    double smoothPitch() const { return pitch_; }  ///< [rad]
    double way() const { return way_; }            ///< [m] since the first line
    /// From there on [m] the tracks have passed over the ground from end to end.  Behind it, their first pose alone
    /// bounds the ground, and hollows under it are unknown.
    double passedFrom() const { return passedFrom_; }
    /// The highest that the ground can be there [m]; empty where the tracks have not been.
    std::optional<double> highestAt(double x) const;

private:
    void lower();

    RobotModel robot_;
    double turnsAt_;  ///< [m] before the base origin
    std::optional<double> travelled_;
    double pitch_ = 0.0, way_ = 0.0, passedFrom_ = 0.0;
    Vec2 point_;  ///< of the tracks' lower edge, about which the robot turns
    Pose pose_;
    bool moved_ = false;
    std::map<long, double> highest_;
};

}  // namespace terratact
