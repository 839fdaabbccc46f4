#include "core/robot/kinematics.h"

#include <algorithm>
#include <cmath>

namespace terratact {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns a flipper as a hull in the base frame.
TaperedHull flipperHull(const FlipperGeometry& flipper, double angle)
{
    const Vec2 axis = flipperAxis(flipper, angle);
    const Vec2 tip{flipper.pivot.x + flipper.axleDistance * axis.x,
                   flipper.pivot.z + flipper.axleDistance * axis.z};
    return {flipper.pivot, tip, flipper.pivotRadius, flipper.tipRadius};
}

TaperedHull moved(const TaperedHull& hull, const Pose& pose)
{
    return {toWorld(pose, hull.a), toWorld(pose, hull.b), hull.ra, hull.rb};
}

double circleBottom(Vec2 centre, double radius, double x)
{
    const double dx = x - centre.x;
    if (std::abs(dx) > radius) return kInfinity;
    return centre.z - std::sqrt(radius * radius - dx * dx);
}

double segmentAt(Vec2 p, Vec2 q, double x)
{
    if (p.x > q.x) std::swap(p, q);
    if (x < p.x || x > q.x) return kInfinity;
    if (q.x - p.x < 1e-12) return std::min(p.z, q.z);
    return p.z + (q.z - p.z) * (x - p.x) / (q.x - p.x);
}

}  // namespace

Vec2 rotated(Vec2 v, double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.z, s * v.x + c * v.z};
}

Vec2 toWorld(const Pose& pose, Vec2 pointInBase)
{
    const Vec2 r = rotated(pointInBase, pose.pitch);
    return {pose.base.x + r.x, pose.base.z + r.z};
}

Vec2 imuPosition(const RobotModel& robot, const Pose& pose)
{
    return toWorld(pose, robot.imu);
}

double trackWay(const Pose& from, const Pose& to)
{
    const Vec2 along = rotated({1.0, 0.0}, (from.pitch + to.pitch) / 2.0);
    return (to.base.x - from.base.x) * along.x + (to.base.z - from.base.z) * along.z;
}

Pose poseInDem(const RobotModel& robot, double pitch, double front, double rear)
{
    const Vec2 imu = rotated(robot.imu, pitch);
    return {.base = {-imu.x, -imu.z}, .pitch = pitch, .front = front, .rear = rear};
}

double turnSign(const FlipperGeometry& flipper)
{
    return flipper.pivot.x >= 0.0 ? 1.0 : -1.0;
}

Vec2 flipperAxis(const FlipperGeometry& flipper, double angle)
{
    const double elevation = angle - flipper.taper();
    return {turnSign(flipper) * std::cos(elevation), std::sin(elevation)};
}

TaperedHull trackAt(const RobotModel& robot, const Pose& pose)
{
    const double half = 0.5 * robot.trackAxle;
    return moved(
        {{-half, robot.trackZ}, {half, robot.trackZ}, robot.trackRadius, robot.trackRadius}, pose);
}

TaperedHull flipperAt(const FlipperGeometry& flipper, double angle, const Pose& pose)
{
    return moved(flipperHull(flipper, angle), pose);
}

RobotShape shapeAt(const RobotModel& robot, const Pose& pose)
{
    RobotShape shape{.track = trackAt(robot, pose),
                     .front = flipperAt(robot.front, pose.front, pose),
                     .rear = flipperAt(robot.rear, pose.rear, pose),
                     .body = robot.body};
    for (auto& polygon : shape.body)
        for (Vec2& p : polygon) p = toWorld(pose, p);
    return shape;
}

// The two common tangents touch circle a and b where the outward normal n satisfies n·(b − a) = ra − rb:
// n = d cos φ ± d⊥ sin φ, cos φ = (ra − rb) / |b − a|. d is the unit vector from a to b.
double lowerBoundary(const TaperedHull& hull, double x)
{
    if (x < std::min(hull.a.x - hull.ra, hull.b.x - hull.rb)) return kInfinity;
    if (x > std::max(hull.a.x + hull.ra, hull.b.x + hull.rb)) return kInfinity;
    double lowest = std::min(circleBottom(hull.a, hull.ra, x), circleBottom(hull.b, hull.rb, x));
    const Vec2 ab{hull.b.x - hull.a.x, hull.b.z - hull.a.z};
    const double length = std::hypot(ab.x, ab.z);
    if (length <= std::abs(hull.ra - hull.rb)) return lowest;  // one circle holds the other
    const double cosine = (hull.ra - hull.rb) / length;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const Vec2 d{ab.x / length, ab.z / length};
    for (const double side : {1.0, -1.0}) {
        const Vec2 n{d.x * cosine - side * d.z * sine, d.z * cosine + side * d.x * sine};
        const Vec2 p{hull.a.x + hull.ra * n.x, hull.a.z + hull.ra * n.z};
        const Vec2 q{hull.b.x + hull.rb * n.x, hull.b.z + hull.rb * n.z};
        lowest = std::min(lowest, segmentAt(p, q, x));
    }
    return lowest;
}

double reachOf(const RobotModel& robot)
{
    double reach = std::hypot(0.5 * robot.trackAxle, robot.trackZ) + robot.trackRadius;
    for (const FlipperGeometry& f : {robot.front, robot.rear})
        reach = std::max(reach, std::hypot(f.pivot.x, f.pivot.z)
                                    + std::max(f.pivotRadius, f.axleDistance + f.tipRadius));
    for (const auto& polygon : robot.body)
        for (const Vec2 corner : polygon) reach = std::max(reach, std::hypot(corner.x, corner.z));
    return reach;
}

double lowerBoundary(const std::vector<Vec2>& polygon, double x)
{
    double lowest = kInfinity;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        lowest = std::min(lowest, segmentAt(polygon[i], polygon[(i + 1) % polygon.size()], x));
    return lowest;
}

double lowerEnvelope(const RobotShape& shape, double x)
{
    double lowest = std::min({lowerBoundary(shape.track, x), lowerBoundary(shape.front, x),
                              lowerBoundary(shape.rear, x)});
    for (const auto& polygon : shape.body) lowest = std::min(lowest, lowerBoundary(polygon, x));
    return lowest;
}

// The lower edge is the tangent whose outward normal is the flipper's axis turned by −(90° − taper):
// at joint angle 0 the edge lies along x and its normal points straight down.
Vec2 edgePoint(const FlipperGeometry& flipper, double angle, const Pose& pose, double share)
{
    const double turn = turnSign(flipper);
    const Vec2 along = rotated({turn, 0.0}, turn * angle);
    const Vec2 down = rotated({0.0, -1.0}, turn * angle);
    const double s = share * flipper.edgeLength();
    return toWorld(pose, {flipper.pivot.x + flipper.pivotRadius * down.x + s * along.x,
                          flipper.pivot.z + flipper.pivotRadius * down.z + s * along.z});
}

Vec2 elementPosition(const RobotModel& robot, const Pose& pose, double share)
{
    return edgePoint(robot.front, pose.front, pose, share);
}

}  // namespace terratact
