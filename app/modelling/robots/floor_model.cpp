#include "app/modelling/robots/floor_model.h"

#include <algorithm>
#include <cmath>

#include "core/robot/kinematics.h"

namespace terratact {
namespace {

constexpr double kFloorGravity = 9.81;  // [m/s²]
constexpr double kTouch = 1e-7;         // [m] circles of one height touch together

struct FloorCircle {
    Vec2 centre;
    double radius = 0.0;
};
enum : std::size_t { RearWheel, FrontWheel, RearPivot, FrontPivot, RearTipCircle, FrontTipCircle };
using FloorCircles = std::array<FloorCircle, 6>;

Vec2 onAxis(const FlipperGeometry& flipper, double angle, double distance)
{
    const Vec2 axis = flipperAxis(flipper, angle);
    return {flipper.pivot.x + distance * axis.x, flipper.pivot.z + distance * axis.z};
}

FloorCircles circlesOf(const RobotModel& r, double front, double rear)
{
    const double half = 0.5 * r.trackAxle;
    return {FloorCircle{{-half, r.trackZ}, r.trackRadius},
            FloorCircle{{half, r.trackZ}, r.trackRadius},
            FloorCircle{r.rear.pivot, r.rear.pivotRadius},
            FloorCircle{r.front.pivot, r.front.pivotRadius},
            FloorCircle{onAxis(r.rear, rear, r.rear.axleDistance), r.rear.tipRadius},
            FloorCircle{onAxis(r.front, front, r.front.axleDistance), r.front.tipRadius}};
}

Vec2 massOf(const RobotModel& r, double front, double rear)
{
    const Vec2 f = onAxis(r.front, front, r.front.comDistance);
    const Vec2 b = onAxis(r.rear, rear, r.rear.comDistance);
    const double total = r.totalMass();
    return {(r.bodyMass * r.bodyCom.x + r.front.mass * f.x + r.rear.mass * b.x) / total,
            (r.bodyMass * r.bodyCom.z + r.front.mass * f.z + r.rear.mass * b.z) / total};
}

/// Axes of the floor in the base frame for one pitch.
struct FloorAxes {
    double cosine, sine;
    explicit FloorAxes(double pitch) : cosine(std::cos(pitch)), sine(-std::sin(pitch)) {}
    double along(Vec2 p) const { return cosine * p.x + sine * p.z; }
    double above(Vec2 p) const { return cosine * p.z - sine * p.x; }
    double lowest(const FloorCircle& c) const { return above(c.centre) - c.radius; }
};

/// Returns the pitch at which both circles touch the floor; empty if one contains the other.
std::optional<double> pitchOn(const FloorCircle& a, const FloorCircle& b)
{
    const double dx = b.centre.x - a.centre.x, dz = b.centre.z - a.centre.z;
    const double distance = std::hypot(dx, dz), rise = b.radius - a.radius;
    if (distance <= std::abs(rise) + 1e-9) return {};
    return std::asin(rise / distance) - std::atan2(dz, dx);
}

/// Returns the torque [N m] that the axle's motors need at this load of the tips.
double torqueOfTips(const FlipperGeometry& f, double angle, double load, double contact,
                    const FloorAxes& floor)
{
    const double pivot = floor.along(f.pivot);
    const double weight = floor.along(onAxis(f, angle, f.comDistance));
    return std::abs(load * (contact - pivot)) - f.mass * kFloorGravity * std::abs(weight - pivot);
}

}  // namespace

FloorParameters parametersOf(const RobotModel& robot)
{
    FloorParameters p = FloorParameters::Zero();
    p[FloorParameter::TrackAxle] = robot.trackAxle;
    p[FloorParameter::FrontLength] = robot.front.axleDistance;
    p[FloorParameter::RearLength] = robot.rear.axleDistance;
    p[FloorParameter::FrontTip] = robot.front.tipRadius;
    p[FloorParameter::RearTip] = robot.rear.tipRadius;
    return p;
}

RobotModel withParameters(RobotModel robot, const FloorParameters& parameters)
{
    robot.trackAxle = parameters[FloorParameter::TrackAxle];
    robot.front.axleDistance = parameters[FloorParameter::FrontLength];
    robot.rear.axleDistance = parameters[FloorParameter::RearLength];
    robot.front.tipRadius = parameters[FloorParameter::FrontTip];
    robot.rear.tipRadius = parameters[FloorParameter::RearTip];
    return robot;
}

std::optional<FloorRest> restOnFloor(const RobotModel& robot, double front, double rear)
{
    const FloorCircles circles = circlesOf(robot, front, rear);
    const Vec2 mass = massOf(robot, front, rear);
    for (const FloorCircle& a : circles)
        for (const FloorCircle& b : circles) {
            if (&a == &b) continue;
            const auto pitch = pitchOn(a, b);
            if (!pitch || std::abs(*pitch) > 1.2) continue;
            const FloorAxes floor(*pitch);
            const double level = floor.lowest(a), x = floor.along(mass);
            if (floor.along(a.centre) > x || floor.along(b.centre) < x) continue;
            if (std::any_of(circles.begin(), circles.end(),
                            [&](const FloorCircle& c) { return floor.lowest(c) < level - kTouch; }))
                continue;
            FloorRest rest{.pitch = *pitch,
                           .support = {floor.along(a.centre), floor.along(b.centre)},
                           .mass = x,
                           .floor = level,
                           .onFrontTip = &b == &circles[FrontTipCircle],
                           .onRearTip = &a == &circles[RearTipCircle]};
            const double span = rest.support[1] - rest.support[0];
            const double weight = robot.totalMass() * kFloorGravity;
            if (rest.onFrontTip)
                rest.frontTorque =
                    torqueOfTips(robot.front, front, weight * (x - rest.support[0]) / span,
                                 rest.support[1], floor);
            if (rest.onRearTip)
                rest.rearTorque =
                    torqueOfTips(robot.rear, rear, weight * (rest.support[1] - x) / span,
                                 rest.support[0], floor);
            return rest;
        }
    return {};
}

double tipAboveFloor(const FloorRest& rest, const FlipperGeometry& flipper, double angle)
{
    const Vec2 tip = onAxis(flipper, angle, flipper.axleDistance);
    return FloorAxes(rest.pitch).above(tip) - flipper.tipRadius - rest.floor;
}

}  // namespace terratact
