#pragma once

#include <map>
#include <optional>

#include "core/robot/kinematics.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Smoothed mean current of the rear flippers; it shows whether they carry a load. It stays where no
/// current was measured.
class RearLoad {
public:
    static constexpr double kLoaded = 0.4;  ///< [A] per motor
    void add(const Measurement& line);
    double current() const { return current_; }  ///< [A]
    bool isLoaded() const { return current_ > kLoaded; }

private:
    double current_ = 0.0;
};

/// Returns the angle [rad] from the tracks up to the line of rest, when the rear flippers carry a
/// load. The line is the tangent from below to the front track wheel and the rear flippers' tips.
/// Returns 0 if the tips are above the tracks.
double supportAngle(const RobotModel& robot, double rear);

/// Returns x of the robot's centre of mass in its own frame [m], with the flippers' masses at their pivots.
double centreOfMass(const RobotModel& robot);

/// Upper bound of the ground under the path of the tracks. No ground is higher than the lowest
/// position of the tracks above it, and most high spots have carried them. The frame is along
/// gravity and begins with the first line. Dead reckoning moves the robot by a way ds of the tracks
/// along its line of rest:
///   ds / cos β · (cos(θ + β), sin(θ + β)).
/// β is supportAngle() while the rear flippers carry a load, else 0. The robot turns about the
/// point of its tracks' lower edge below its centre of mass. The map keeps kKept to both sides. It
/// has no clock.
class DrivenGround {
public:
    static constexpr double kCell = 0.02;  ///< [m]
    static constexpr double kKept = 3.0;   ///< [m]

    explicit DrivenGround(const RobotModel& robot);

    /// Adds the next line. Ignores a line without odometry.
    void add(const Measurement& line, bool isRearLoaded);

    /// Returns the pose of the last line, left and right averaged.
    const Pose& pose() const { return pose_; }
    /// Returns pose() with another pitch and another angle of the front flippers.
    Pose poseWith(double pitch, double front) const;
    bool hasMoved() const { return moved_; }  ///< true if the robot moved forward at the last line
    double smoothPitch() const { return pitch_; }  ///< [rad]
    double way() const { return way_; }            ///< [m] since the first line
    /// Returns the x [m] from which the tracks have touched the ground over their full length.
    /// Behind it, only their first pose bounds the ground, and hollows under it are unknown.
    double passedFrom() const { return passedFrom_; }
    /// Returns the highest possible ground at x [m]; empty where the tracks have not been.
    std::optional<double> highestAt(double x) const;

private:
    void lower();

    RobotModel robot_;
    double turnsAt_;  ///< distance in front of the base origin [m]
    std::optional<double> travelled_;
    double pitch_ = 0.0, way_ = 0.0, passedFrom_ = 0.0;
    Vec2 point_;  ///< point of the tracks' lower edge about which the robot turns
    Pose pose_;
    bool moved_ = false;
    std::map<long, double> highest_;
};

}  // namespace terratact
