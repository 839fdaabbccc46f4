#include "core/sim/rest/part_motion.h"

#include <cmath>

namespace terratact {
namespace {

Vec2 relative(Vec2 point, Vec2 origin)
{
    return {point.x - origin.x, point.z - origin.z};
}

/// Returns (n, n · ⊥c).
Eigen::Vector3d momentOf(Vec2 n, Vec2 c)
{
    return {n.x, n.z, n.z * c.x - n.x * c.z};
}

}  // namespace

void PartForces::addWeight(double weight, Vec2 point)
{
    const Vec2 c = relative(point, base_);
    force_ += weight * momentOf({0.0, 1.0}, c);
    turning_ += weight * Triple(0.0, 1.0, c.z);
}

void PartForces::addSpring(const SkinSpring& spring, Vec2 point, const Penetration& hit)
{
    const Vec2 p = relative(point, base_);
    const Vec2 n = hit.normal;
    // The centre of the circle; p itself on a straight side, whose distance is 0.
    const Vec2 c{p.x - hit.toCentre * n.x, p.z - hit.toCentre * n.z};
    const Triple along = momentOf(n, p);
    const Triple across = momentOf({-n.z, n.x}, c);
    force_ += spring.force * along;
    turning_ += spring.force * Triple(n.x, n.z, n.x * c.x + n.z * c.z);
    bending_ += spring.gradient * along * along.transpose();
    if (hit.toCentre > 0.0)
        bending_ -= spring.force / hit.toCentre * across * across.transpose();
    else
        sliding_ += spring.force * across;
}

PartMotion::Plane::Plane(const RobotModel& robot, const TwoTrackPose& pose, Vec2 planeOrigin,
                         double y)
    : base(pose.base), origin(planeOrigin), up{-std::sin(pose.pitch), std::cos(pose.pitch)}
{
    const double height = robot.trackRadius - robot.trackZ;
    lift1 = y * std::cos(pose.roll) + height * std::sin(pose.roll);
    lift2 = -y * std::sin(pose.roll) + height * std::cos(pose.roll);
}

PartMotion::PartMotion(const Plane& plane, double differential, Vec2 pivot, double flipper)
    : plane_(plane), origin_(relative(plane.origin, plane.base)),
      pivot_(flipper == 0.0 ? Vec2{} : relative(pivot, plane.base)), differential_(differential),
      flipper_(flipper)
{
    velocities_.row(kHeight) << 0.0, 1.0, 0.0;
    velocities_.row(kPitch) << 0.0, 0.0, 1.0;
    velocities_.row(kRoll) << plane.lift1 * plane.up.x, plane.lift1 * plane.up.z, 0.0;
    velocities_.row(kDifferential) << differential * origin_.z, -differential * origin_.x,
        differential;
    velocities_.row(kFlipper) << flipper * pivot_.z, -flipper * pivot_.x, flipper;
}

PartMotion::Hessian PartMotion::hessian(const PartForces& forces) const
{
    // Second derivatives of points: those of a rotation are −(c − centre).
    const auto& f = forces.turning_;
    const auto along = [&](Vec2 v) { return f[0] * v.x + f[1] * v.z; };
    const double toOrigin = f[2] - along(origin_);
    const double toPivot = f[2] - along(pivot_);
    const Vec2 up = plane_.up;
    Hessian h = Hessian::Zero();
    const auto set = [&](int i, int j, double value) { h(i, j) = h(j, i) = value; };
    set(kPitch, kPitch, -f[2]);
    set(kRoll, kRoll, plane_.lift2 * along(up));
    set(kPitch, kRoll, plane_.lift1 * along({-up.z, up.x}));
    set(kDifferential, kDifferential, -differential_ * differential_ * toOrigin);
    set(kPitch, kDifferential, -differential_ * toOrigin);
    set(kFlipper, kFlipper, -flipper_ * flipper_ * toPivot);
    set(kPitch, kFlipper, -flipper_ * toPivot);
    set(kDifferential, kFlipper, -differential_ * flipper_ * toPivot);

    Gradient turn;
    turn << 0.0, 1.0, 0.0, differential_, flipper_;
    const Gradient slide = velocities_ * forces.sliding_;
    return h + velocities_ * forces.bending_ * velocities_.transpose() + turn * slide.transpose()
         + slide * turn.transpose();
}

}  // namespace terratact
