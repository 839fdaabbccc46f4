#include "core/sim/rest/two_track_potential.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/sim/rest/part_motion.h"
#include "core/sim/rest/rest_search.h"
#include "core/sim/rest/skin_contact.h"

namespace terratact {
namespace {

using Coordinate = TwoTrackCoordinate;

/// Returns true if a point of the line is within a polygon's range of x and above its lower end. A
/// polygon that cannot touch the line then costs little.
bool mayTouch(const std::vector<Vec2>& polygon, double skin, const std::vector<Vec2>& line)
{
    const auto [left, right] = std::ranges::minmax(polygon, {}, &Vec2::x);
    const double lowest = std::ranges::min(polygon, {}, &Vec2::z).z - skin;
    const auto before = [](Vec2 p, double x) { return p.x < x; };
    auto p = std::lower_bound(line.begin(), line.end(), left.x - skin, before);
    for (; p != line.end() && p->x <= right.x + skin; ++p)
        if (p->z >= lowest) return true;
    return false;
}

const FlipperGeometry& geometryOf(const RobotModel& robot, Flipper flipper)
{
    return flipper == Flipper::FrontLeft || flipper == Flipper::FrontRight ? robot.front
                                                                           : robot.rear;
}

Side sideOf(Flipper flipper)
{
    return flipper == Flipper::FrontLeft || flipper == Flipper::RearLeft ? Side::Left : Side::Right;
}

}  // namespace

/// Energy and derivatives of one side. Its coordinates are z, pitch, roll, differential, front and
/// rear flipper.
struct TwoTrackPotential::SideSum {
    static constexpr int kFront = 4, kRear = 5, kCount = 6;
    double energy = 0.0;
    Eigen::Matrix<double, kCount, 1> gradient = Eigen::Matrix<double, kCount, 1>::Zero();
    Eigen::Matrix<double, kCount, kCount> hessian = Eigen::Matrix<double, kCount, kCount>::Zero();

    void add(const Part& part);

    /// Adds this side to the whole robot's derivatives.
    void addTo(TwoTrackDerivatives& whole, double sign) const
    {
        Eigen::Matrix<double, Coordinate::Count, kCount> turn;
        turn.setZero();
        turn(Coordinate::Z, 0) = turn(Coordinate::Pitch, 1) = turn(Coordinate::Roll, 2) = 1.0;
        turn(Coordinate::Differential, 3) = 1.0;
        turn(Coordinate::FrontMean, kFront) = turn(Coordinate::RearMean, kRear) = 1.0;
        turn(Coordinate::FrontHalf, kFront) = turn(Coordinate::RearHalf, kRear) = sign;
        whole.gradient += turn * gradient;
        whole.hessian += turn * hessian * turn.transpose();
    }
};

/// A part of one side: its forces, how it moves, and where its derivatives count.
struct TwoTrackPotential::Part {
    PartForces forces;
    PartMotion motion;
    GroundContact::Part kind;
    /// kFront or kRear of a flipper. Other parts do not move by a flipper's angle: any of both.
    int flipper;
};

void TwoTrackPotential::SideSum::add(const Part& part)
{
    const PartMotion::Gradient g = part.motion.gradient(part.forces);
    const PartMotion::Hessian h = part.motion.hessian(part.forces);
    const std::array<int, PartMotion::kCount> place{0, 1, 2, 3, part.flipper};
    for (int i = 0; i < PartMotion::kCount; ++i) {
        const int row = place[static_cast<std::size_t>(i)];
        gradient[row] += g[i];
        for (int j = 0; j < PartMotion::kCount; ++j)
            hessian(row, place[static_cast<std::size_t>(j)]) += h(i, j);
    }
}

TwoTrackPotential::TwoTrackPotential(const RobotModel& robot, const GroundLines& terrain, double x,
                                     const PerFlipper<FlipperDrive>& drives,
                                     const GroundOptions& ground)
    : robot_(robot), ground_(ground)
{
    for (std::size_t i = 0; i < kFlippers; ++i) torques_[i] = torqueOf(drives[i]);
    ground_.softStiffness *= 0.5;
    const double reach = searchReach(robot, ground);
    for (const Side side : {Side::Left, Side::Right}) {
        const double sign = signOf(side);
        const TerrainProfile& track = terrain.under(sign * robot.lateral.trackY);
        const TerrainProfile& flipper = terrain.under(sign * robot.lateral.flipperY);
        std::vector<Vec2>& trackLine = lines_[indexOf(side)];
        trackLine = track.sampled(x - reach, x + reach, ground.spacing);
        lines_[2 + indexOf(side)] =
            &flipper == &track ? trackLine : flipper.sampled(x - reach, x + reach, ground.spacing);
    }
    for (const auto& line : lines_) terrainPoints_ += line.size();
}

const std::vector<Vec2>& TwoTrackPotential::trackLine(Side side) const
{
    return lines_[indexOf(side)];
}

const std::vector<Vec2>& TwoTrackPotential::flipperLine(Side side) const
{
    return lines_[2 + indexOf(side)];
}

double TwoTrackPotential::operator()(const TwoTrackPose& pose, double stiffness,
                                     TwoTrackDerivatives* derivatives, SideContacts* contacts) const
{
    TwoTrackDerivatives sum{TwoTrackVector::Zero(), TwoTrackMatrix::Zero()};
    double energy = bodyWeight(pose, sum);
    for (const Side side : {Side::Left, Side::Right}) {
        const SideSum part =
            oneSide(pose, side, 0.5 * stiffness, contacts ? &(*contacts)[indexOf(side)] : nullptr);
        energy += part.energy;
        if (derivatives) part.addTo(sum, signOf(side));
    }
    if (derivatives) *derivatives = sum;
    return energy;
}

/// The body is rigid: z = base + x sin θ + (y sin φ + z cos φ) cos θ.
double TwoTrackPotential::bodyWeight(const TwoTrackPose& pose, TwoTrackDerivatives& sum) const
{
    const double weight = robot_.bodyMass * kGravity;
    const double sinRoll = std::sin(pose.roll), cosRoll = std::cos(pose.roll);
    const double sine = std::sin(pose.pitch), cosine = std::cos(pose.pitch);
    const double x = robot_.bodyCom.x;
    const double up = robot_.lateral.bodyComY * sinRoll + robot_.bodyCom.z * cosRoll;
    const double side = robot_.lateral.bodyComY * cosRoll - robot_.bodyCom.z * sinRoll;
    sum.gradient[Coordinate::Z] += weight;
    sum.gradient[Coordinate::Pitch] += weight * (x * cosine - up * sine);
    sum.gradient[Coordinate::Roll] += weight * side * cosine;
    sum.hessian(Coordinate::Pitch, Coordinate::Pitch) -= weight * (x * sine + up * cosine);
    sum.hessian(Coordinate::Roll, Coordinate::Roll) -= weight * up * cosine;
    sum.hessian(Coordinate::Pitch, Coordinate::Roll) -= weight * side * sine;
    sum.hessian(Coordinate::Roll, Coordinate::Pitch) -= weight * side * sine;
    return weight * (pose.base.z + x * sine + up * cosine);
}

TwoTrackPotential::SideSum TwoTrackPotential::oneSide(const TwoTrackPose& pose, Side side,
                                                      double stiffness,
                                                      std::vector<GroundContact>* contacts) const
{
    SideSum sum;
    addTrackAndBody(sum, pose, side, stiffness, contacts);
    addFlipper(sum, pose, frontFlipper(side), stiffness, contacts);
    addFlipper(sum, pose, rearFlipper(side), stiffness, contacts);
    return sum;
}

void TwoTrackPotential::addTrackAndBody(SideSum& sum, const TwoTrackPose& pose, Side side,
                                        double stiffness,
                                        std::vector<GroundContact>* contacts) const
{
    const std::vector<Vec2>& line = trackLine(side);
    const double y = robot_.lateral.trackY;
    const Pose plane = sidePose(robot_, pose, side, y);
    const PartMotion::Plane motion{robot_, pose, plane.base, signOf(side) * y};
    Part track{PartForces(pose.base), PartMotion(motion, signOf(side), {}, 0.0),
               GroundContact::Part::Track, SideSum::kFront};
    sum.energy +=
        addSkin(track, SkinHull(trackAt(robot_, plane), ground_.skin), line, stiffness, contacts);
    sum.add(track);

    const Pose body{plane.base, pose.pitch};
    Part part{PartForces(pose.base), PartMotion(motion, 0.0, {}, 0.0), GroundContact::Part::Body,
              SideSum::kFront};
    std::vector<Vec2> polygon;
    for (const auto& corners : robot_.body) {
        polygon.clear();
        for (const Vec2 corner : corners) polygon.push_back(toWorld(body, corner));
        if (mayTouch(polygon, ground_.skin, line))
            sum.energy +=
                addSkin(part, SkinPolygon(polygon, ground_.skin), line, stiffness, contacts);
    }
    sum.add(part);
}

void TwoTrackPotential::addFlipper(SideSum& sum, const TwoTrackPose& pose, Flipper flipper,
                                   double stiffness, std::vector<GroundContact>* contacts) const
{
    const FlipperGeometry& f = geometryOf(robot_, flipper);
    const Side side = sideOf(flipper);
    const bool front = &f == &robot_.front;
    const double angle = pose.flippers[indexOf(flipper)];
    const double y = robot_.lateral.flipperY;
    const Pose plane = sidePose(robot_, pose, side, y);
    const PartMotion::Plane motion{robot_, pose, plane.base, signOf(side) * y};
    Part part{PartForces(pose.base),
              PartMotion(motion, signOf(side), toWorld(plane, f.pivot), turnSign(f)),
              front ? GroundContact::Part::Front : GroundContact::Part::Rear,
              front ? SideSum::kFront : SideSum::kRear};

    const double weight = 0.5 * f.mass * kGravity;  // f.mass is that of both flippers
    const Vec2 axis = flipperAxis(f, angle);
    const Vec2 com =
        toWorld(plane, {f.pivot.x + f.comDistance * axis.x, f.pivot.z + f.comDistance * axis.z});
    part.forces.addWeight(weight, com);
    sum.energy += weight * com.z + torques_[indexOf(flipper)] * angle;
    sum.gradient[part.flipper] += torques_[indexOf(flipper)];
    sum.energy += addSkin(part, SkinHull(flipperAt(f, angle, plane), ground_.skin),
                          flipperLine(side), stiffness, contacts);
    sum.add(part);
}

template <class Hull>
double TwoTrackPotential::addSkin(Part& part, const Hull& hull, const std::vector<Vec2>& line,
                                  double stiffness, std::vector<GroundContact>* contacts) const
{
    double energy = 0.0;
    terrainPoints_ += forEachHit(line, hull, [&](Vec2 point, const Penetration& hit) {
        const SkinSpring spring = skinSpring(hit.depth, stiffness, ground_);
        energy += spring.energy;
        part.forces.addSpring(spring, point, hit);
        if (contacts)
            contacts->push_back({part.kind,
                                 point,
                                 {-spring.force * hit.normal.x, -spring.force * hit.normal.z},
                                 hit.depth});
    });
    return energy;
}

double TwoTrackPotential::clearHeight(TwoTrackPose pose) const
{
    pose.base.z = 0.0;
    double height = -1e9;
    const auto clear = [&](const auto& part, const std::vector<Vec2>& line) {
        terrainPoints_ += line.size();
        for (const Vec2 p : line) {
            const double lower = lowerBoundary(part, p.x);
            if (std::isfinite(lower)) height = std::max(height, p.z - lower);
        }
    };
    for (const Side side : {Side::Left, Side::Right}) {
        const Pose track = sidePose(robot_, pose, side, robot_.lateral.trackY);
        const Pose flippers = sidePose(robot_, pose, side, robot_.lateral.flipperY);
        clear(trackAt(robot_, track), trackLine(side));
        for (const auto& polygon : shapeAt(robot_, {track.base, pose.pitch}).body)
            clear(polygon, trackLine(side));
        clear(flipperAt(robot_.front, flippers.front, flippers), flipperLine(side));
        clear(flipperAt(robot_.rear, flippers.rear, flippers), flipperLine(side));
    }
    return height;
}

}  // namespace terratact
