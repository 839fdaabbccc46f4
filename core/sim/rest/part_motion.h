#pragma once

#include <Eigen/Core>

#include "core/robot/two_tracks.h"
#include "core/sim/rest/ground_contact.h"
#include "core/sim/rest/skin_contact.h"

namespace terratact {

/// Sums over the forces on one rigid part. They suffice for the first and second derivatives of the energy by every
/// coordinate that moves the part. So each contact costs little. Points are relative to the base. n: direction of a
/// force F; t = ⊥n with ⊥(x, z) = (−z, x).
class PartForces {
public:
    explicit PartForces(Vec2 base) : base_(base) {}

    /// Adds a weight [N] at a point.
    void addWeight(double weight, Vec2 point);

    /// Adds a spring at a point of the ground that is inside of the part's skin.
    void addSpring(const SkinSpring& spring, Vec2 point, const Penetration& hit);

private:
    friend class PartMotion;
    using Triple = Eigen::Vector3d;

    Vec2 base_;
    Triple force_ = Triple::Zero();                      ///< Σ F (n, n · ⊥c)
    Triple turning_ = Triple::Zero();                    ///< Σ F (n, n · c)
    Triple sliding_ = Triple::Zero();                    ///< Σ F (t, t · ⊥c) on straight sides
    Eigen::Matrix3d bending_ = Eigen::Matrix3d::Zero();  ///< Σ of springs and of curved boundaries
};

/// Motion of a rigid part of a robot with two tracks in its vertical plane (sidePose()), to second
/// order. A point c of the part has, by each of the five coordinates, the velocity
///   height        (0, 1)
///   pitch         ⊥(c − base)
///   roll          lift' up
///   differential  ± ⊥(c − plane's base), for the parts of a side
///   flipper       ± ⊥(c − pivot), for a flipper
class PartMotion {
public:
    enum : int { kHeight, kPitch, kRoll, kDifferential, kFlipper, kCount };
    using Gradient = Eigen::Matrix<double, kCount, 1>;
    using Hessian = Eigen::Matrix<double, kCount, kCount>;

    /// Plane at the signed y of a pose.
    struct Plane {
        Plane(const RobotModel& robot, const TwoTrackPose& pose, Vec2 origin, double y);
        Vec2 base, origin, up;
        double lift1, lift2;  ///< first and second derivative of sideLift() by roll
    };

    /// differential: +1 left, −1 right, 0 for the body. flipper: turnSign() about `pivot`; 0: none.
    PartMotion(const Plane& plane, double differential, Vec2 pivot, double flipper);

    /// Return the derivatives of the energy.
    Gradient gradient(const PartForces& forces) const { return velocities_ * forces.force_; }
    /// The depth of a point p in a circle with centre c is radius − |p − c|. On a straight side it is
    /// the distance to a line that turns with the part.
    Hessian hessian(const PartForces& forces) const;

private:
    Plane plane_;
    Vec2 origin_, pivot_;  ///< relative to the base
    double differential_, flipper_;
    /// n · velocity = velocities_ (n, n · ⊥c)
    Eigen::Matrix<double, kCount, 3> velocities_;
};

}  // namespace terratact
