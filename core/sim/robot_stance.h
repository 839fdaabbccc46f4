#pragma once

#include <array>
#include <optional>

#include "core/robot/kinematics.h"
#include "core/robot/robot_model.h"
#include "core/sim/rest/rest_pose.h"
#include "core/sim/rest/two_track_rest.h"
#include "core/terrain/bins.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

/// Targets of a robot's flippers: held angles, or a torque that presses the front ones down.
struct FlipperTargets {
    std::array<double, 2> front{};   ///< [rad] by side
    double rear = 0.0;               ///< [rad] of both sides
    std::optional<double> torque{};  ///< [N m] of both front flippers, instead of their angles
};

/// Rest pose that a simulated robot keeps from step to step. On ground that is one plane, it is that
/// of the plane (core/sim/rest/rest_pose.h), without roll. On other ground, both sides have their own
/// flipper angles, torques and contacts (core/sim/rest/two_track_rest.h).
class RobotStance {
public:
    RobotStance(RobotModel robot, GroundLines ground, const GroundOptions& options = {});

    /// Moves to the rest pose at x, from the present attitude. Returns false and stays where there is
    /// no rest pose.
    bool settle(double x, const FlipperTargets& targets);

    /// Returns the pose in the vertical plane of the middle. Flipper angles are the means of both
    /// sides.
    const Pose& pose() const { return pose_; }
    /// Returns the rest pose of both tracks; empty on one plane.
    const std::optional<TwoTrackRest>& tracks() const { return tracks_; }
    /// Returns the rest pose of the plane. Throws std::logic_error where tracks() has a value.
    const RestPose& plane() const;

    double frontAngle(Side side) const;   ///< [rad]
    double frontTorque(Side side) const;  ///< [N m] of one front flipper, pressing down positive

    /// Returns the true bin heights at the pose: those of one side, or the means of both.
    Heights truth(ProbeSide side = ProbeSide::Middle) const;

    const GroundLines& ground() const { return ground_; }

private:
    bool settlePlane(double x, const FlipperTargets& targets);
    bool settleTracks(double x, const FlipperTargets& targets);

    RobotModel robot_;
    GroundLines ground_;
    GroundOptions options_;
    bool isOnePlane_ = true;
    Pose pose_;
    RestPose plane_;
    std::optional<TwoTrackRest> tracks_;
};

}  // namespace terratact
