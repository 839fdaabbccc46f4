#include "core/terrain/body_ceiling.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/robot/kinematics.h"
#include "core/robot/side_plane.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

namespace {

constexpr int kStepsPerBin = 100;

/// Returns a polygon around a tapered hull: the arc of b on its far side, then the arc of a.
std::vector<std::array<double, 2>> outlineOf(const TaperedHull& hull)
{
    constexpr int kArcPoints = 24;
    const double direction = std::atan2(hull.b.z - hull.a.z, hull.b.x - hull.a.x);
    const double distance = std::hypot(hull.b.x - hull.a.x, hull.b.z - hull.a.z);
    // If one circle contains the other, the arc of the larger one is a full circle.
    const double fall = hull.ra - hull.rb;
    const double phi = distance > std::abs(fall) ? std::acos(fall / distance)
                     : fall >= 0.0               ? 0.0
                                                 : std::numbers::pi;
    std::vector<std::array<double, 2>> points;
    const auto arc = [&](Vec2 centre, double radius, double from, double to) {
        for (int k = 0; k <= kArcPoints; ++k) {
            const double angle = direction + from + (to - from) * k / kArcPoints;
            points.push_back(
                {centre.x + radius * std::cos(angle), centre.z + radius * std::sin(angle)});
        }
    };
    arc(hull.b, hull.rb, -phi, phi);
    arc(hull.a, hull.ra, phi, 2.0 * std::numbers::pi - phi);
    return points;
}

/// Angles of a robot on one plane [rad].
struct PlaneAngles {
    double pitch = 0.0, front = 0.0, rear = 0.0;
};

/// Writes the ceilings of bins first … last − 1.
void writeCeilings(Heights& ceiling, const RobotModel& robot, const PlaneAngles& angles, int first,
                   int last)
{
    if (!std::isfinite(angles.pitch) || !std::isfinite(angles.front) || !std::isfinite(angles.rear))
        throw std::invalid_argument("ceilings need a finite pitch and finite flipper angles");
    const RobotShape shape =
        shapeAt(robot, poseInDem(robot, angles.pitch, angles.front, angles.rear));
    for (int i = first; i < last; ++i) {
        double sum = 0.0;
        for (int k = 0; k < kStepsPerBin; ++k)
            sum += lowerEnvelope(shape, binBegin(i) + kBinWidth * (k + 0.5) / kStepsPerBin);
        ceiling[static_cast<std::size_t>(i)] = sum / kStepsPerBin;
    }
}

}  // namespace

Heights bodyCeiling(const RobotModel& robot, double pitch, double front, double rear)
{
    Heights ceiling{};
    writeCeilings(ceiling, robot, {pitch, front, rear}, 0, kBins);
    return ceiling;
}

Heights sideCeiling(const RobotModel& robot, const TwoTrackReadings& s, Side side)
{
    if (!std::isfinite(s.roll)) throw std::invalid_argument("ceilings need a finite roll");
    const PlaneAngles own{s.pitch, s.flippers[indexOf(frontFlipper(side))],
                          s.flippers[indexOf(rearFlipper(side))]};
    const double sign = signOf(side);
    Heights ceiling{};
    writeCeilings(ceiling, inSidePlane(robot, s.roll, sign * robot.lateral.trackY), own, 0,
                  kFirstFlipperBin);
    writeCeilings(ceiling, inSidePlane(robot, s.roll, sign * robot.lateral.flipperY), own,
                  kFirstFlipperBin, kBins);
    return ceiling;
}

Outline robotOutline(const RobotModel& robot, double pitch, double front, double rear)
{
    const RobotShape shape = shapeAt(robot, poseInDem(robot, pitch, front, rear));
    Outline outline;
    for (const auto& polygon : shape.body) {
        OutlinePart part{OutlinePart::Kind::Body, {}};
        for (const Vec2 p : polygon) part.points.push_back({p.x, p.z});
        outline.push_back(std::move(part));
    }
    outline.push_back({OutlinePart::Kind::Track, outlineOf(shape.track)});
    outline.push_back({OutlinePart::Kind::RearFlipper, outlineOf(shape.rear)});
    outline.push_back({OutlinePart::Kind::FrontFlipper, outlineOf(shape.front)});
    return outline;
}

}  // namespace terratact
