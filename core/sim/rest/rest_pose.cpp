#include "core/sim/rest/rest_pose.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/sim/rest/edge_forces.h"
#include "core/sim/rest/newton_descent.h"
#include "core/sim/rest/rest_search.h"
#include "core/sim/rest/skin_contact.h"

namespace terratact {

namespace {

/// Order of the degrees of freedom in gradients: base height, pitch, front, rear.
enum Freedom { kZ, kPitch, kFront, kRear, kFreedoms };
using Gradient = Eigen::Vector4d;
using Hessian = Eigen::Matrix4d;

/// Returns the velocity of a point per unit rate of a rotation x → z about `centre`.
Vec2 spin(Vec2 point, Vec2 centre)
{
    return {-(point.z - centre.z), point.x - centre.x};
}

/// Potential energy of one robot on one stretch of ground, with its gradient and contacts.
class Potential {
public:
    Potential(const RobotModel& robot, const TerrainProfile& terrain, double x,
              const FlipperDrive& front, const FlipperDrive& rear, const GroundOptions& ground)
        : robot_(robot), ground_(ground), frontTorque_(torqueOf(front)),
          rearTorque_(torqueOf(rear)), line_(lineUnder(robot, terrain, x, ground)),
          terrainPoints_(line_.size())
    {
    }

    /// Returns the energy [J]; gradient [N, N m, N m, N m] and contacts if requested.
    double operator()(const Pose& pose, double stiffness, Gradient* gradient,
                      std::vector<GroundContact>* contacts) const
    {
        Gradient g = Gradient::Zero();
        double energy = weight(pose, g) + frontTorque_ * pose.front + rearTorque_ * pose.rear;
        g[kFront] += frontTorque_;
        g[kRear] += rearTorque_;
        energy += skin(pose, stiffness, g, contacts);
        if (gradient) *gradient = g;
        return energy;
    }

    /// Returns how many ground points were sampled or compared with a part.
    std::size_t terrainPoints() const { return terrainPoints_; }

    /// Returns the least height of the base at which no part touches the line.
    double clearHeight(Pose pose) const
    {
        pose.base.z = 0.0;
        const RobotShape shape = shapeAt(robot_, pose);
        double height = -1e9;
        terrainPoints_ += line_.size();
        for (const Vec2 p : line_) {
            const double lower = lowerEnvelope(shape, p.x);
            if (std::isfinite(lower)) height = std::max(height, p.z - lower);
        }
        return height;
    }

private:
    static std::vector<Vec2> lineUnder(const RobotModel& robot, const TerrainProfile& terrain,
                                       double x, const GroundOptions& ground)
    {
        const double reach = searchReach(robot, ground);
        return terrain.sampled(x - reach, x + reach, ground.spacing);
    }

    double weight(const Pose& pose, Gradient& g) const
    {
        double energy = 0.0;
        const auto add = [&](double mass, Vec2 com) {
            energy += mass * kGravity * com.z;
            g[kZ] += mass * kGravity;
            g[kPitch] += mass * kGravity * spin(com, pose.base).z;
        };
        add(robot_.bodyMass, toWorld(pose, robot_.bodyCom));
        const auto addFlipper = [&](const FlipperGeometry& f, double angle, Freedom freedom) {
            const Vec2 axis = flipperAxis(f, angle);
            const Vec2 com = toWorld(
                pose, {f.pivot.x + f.comDistance * axis.x, f.pivot.z + f.comDistance * axis.z});
            add(f.mass, com);
            g[freedom] += f.mass * kGravity * turnSign(f) * spin(com, toWorld(pose, f.pivot)).z;
        };
        addFlipper(robot_.front, pose.front, kFront);
        addFlipper(robot_.rear, pose.rear, kRear);
        return energy;
    }

    double skin(const Pose& pose, double stiffness, Gradient& g,
                std::vector<GroundContact>* contacts) const
    {
        const RobotShape shape = shapeAt(robot_, pose);
        const Vec2 frontPivot = toWorld(pose, robot_.front.pivot);
        const Vec2 rearPivot = toWorld(pose, robot_.rear.pivot);
        double energy = 0.0;
        const auto add = [&](GroundContact::Part kind, Vec2 point, const Penetration& hit) {
            const SkinSpring spring = skinSpring(hit.depth, stiffness, ground_);
            const double force = spring.force;
            energy += spring.energy;
            // The part's boundary moves outwards with n·v, and the depth changes by the same
            // amount.
            g[kZ] += force * hit.normal.z;
            g[kPitch] += force * dot(hit.normal, spin(point, pose.base));
            if (kind == GroundContact::Part::Front)
                g[kFront] +=
                    force * turnSign(robot_.front) * dot(hit.normal, spin(point, frontPivot));
            if (kind == GroundContact::Part::Rear)
                g[kRear] += force * turnSign(robot_.rear) * dot(hit.normal, spin(point, rearPivot));
            if (contacts)
                contacts->push_back(
                    {kind, point, {-force * hit.normal.x, -force * hit.normal.z}, hit.depth});
        };
        const auto touch = [&](GroundContact::Part kind, const auto& part) {
            terrainPoints_ +=
                forEachHit(line_, part, [&](Vec2 p, const Penetration& hit) { add(kind, p, hit); });
        };
        touch(GroundContact::Part::Track, SkinHull(shape.track, ground_.skin));
        touch(GroundContact::Part::Front, SkinHull(shape.front, ground_.skin));
        touch(GroundContact::Part::Rear, SkinHull(shape.rear, ground_.skin));
        for (const auto& polygon : shape.body)
            touch(GroundContact::Part::Body, SkinPolygon(polygon, ground_.skin));
        return energy;
    }

    const RobotModel& robot_;
    GroundOptions ground_;
    double frontTorque_;
    double rearTorque_;
    std::vector<Vec2> line_;
    mutable std::size_t terrainPoints_;
};

/// The plane's problem for NewtonDescent. The Hessian is the difference of analytic gradients.
class PlaneProblem {
public:
    using State = Pose;
    using Vector = Gradient;
    struct Derivatives {
        Gradient gradient;  ///< 0 for the coordinates that are not free
    };

    PlaneProblem(const Potential& potential, bool frontFree, bool rearFree)
        : potential_(potential), free_{1.0, 1.0, frontFree ? 1.0 : 0.0, rearFree ? 1.0 : 0.0}
    {
    }

    double energy(const Pose& pose, double stiffness, Derivatives& derivatives) const
    {
        Gradient g;
        const double energy = potential_(pose, stiffness, &g, nullptr);
        derivatives.gradient = g.cwiseProduct(free_);
        return energy;
    }

    Gradient step(const Pose& pose, double stiffness, const Derivatives& derivatives) const
    {
        constexpr double kDelta = 1e-7;
        const Gradient& g = derivatives.gradient;
        Hessian h = Hessian::Zero();
        for (int i = 0; i < kFreedoms; ++i) {
            if (free_[i] == 0.0) continue;
            Gradient shifted;
            potential_(moved(pose, Gradient::Unit(i) * kDelta), stiffness, &shifted, nullptr);
            h.col(i) = (shifted.cwiseProduct(free_) - g) / kDelta;
        }
        const Hessian symmetric = 0.5 * (h + h.transpose());
        const Gradient step = newtonStep(symmetric, g).cwiseProduct(free_);
        const double longest =
            std::max(std::abs(step[kZ]) / 0.02, step.tail<3>().cwiseAbs().maxCoeff() / 0.1);
        return longest > 1.0 ? Gradient(step / longest) : step;
    }

    static Pose moved(Pose pose, const Gradient& step)
    {
        pose.base.z += step[kZ];
        pose.pitch += step[kPitch];
        pose.front += step[kFront];
        pose.rear += step[kRear];
        return pose;
    }

    static bool isLost(const Pose&) { return false; }

private:
    const Potential& potential_;
    Gradient free_;
};

/// Lowers the robot from above `pose` onto the ground with growing contact stiffness, or continues
/// from there.
RestPose settle(const RobotModel& robot, const TerrainProfile& terrain, Pose pose,
                const FlipperDrive& front, const FlipperDrive& rear, const GroundOptions& ground,
                Start start)
{
    const Potential potential(robot, terrain, pose.base.x, front, rear, ground);
    const PlaneProblem problem(potential, isPressed(front), isPressed(rear));
    NewtonDescent descent(problem, ground.settled);
    if (start == Start::Above) pose.base.z = potential.clearHeight(pose);
    lower(descent, pose, ground.stiffness, start);

    RestPose rest;
    rest.pose = pose;
    rest.front = front;
    rest.rear = rear;
    rest.iterations = descent.iterations();
    Gradient g;
    rest.energy = potential(pose, ground.stiffness, &g, &rest.contacts);
    rest.frontTorque = torqueOf(front) - g[kFront];
    rest.rearTorque = torqueOf(rear) - g[kRear];
    rest.terrainPoints = potential.terrainPoints();
    return rest;
}

/// Holds front flippers that found no ground, and lets the robot settle again.
RestPose heldAtLowest(const RobotModel& robot, const TerrainProfile& terrain, const RestPose& rest,
                      const GroundOptions& ground)
{
    Pose pose = rest.pose;
    pose.front = kLowestFlipper;
    RestPose held =
        settle(robot, terrain, pose, HoldAngle{kLowestFlipper}, rest.rear, ground, Start::Above);
    held.iterations += rest.iterations;
    held.terrainPoints += rest.terrainPoints;
    return held;
}

/// Lets a held axle with overloaded motors give way until their limit balances the load.
RestPose yielded(const RobotModel& robot, const TerrainProfile& terrain, const RestPose& rest,
                 const GroundOptions& ground)
{
    const double limit = 2.0 * robot.maxFlipperTorque;
    const FlipperDrive front = sustained(rest.front, rest.frontTorque, limit);
    const FlipperDrive rear = sustained(rest.rear, rest.rearTorque, limit);
    if (isPressed(front) == isPressed(rest.front) && isPressed(rear) == isPressed(rest.rear))
        return rest;
    RestPose after = settle(robot, terrain, rest.pose, front, rear, ground, Start::Here);
    after.iterations += rest.iterations;
    after.terrainPoints += rest.terrainPoints;
    return after;
}

}  // namespace

Result<RestPose> restPose(const RobotModel& robot, const TerrainProfile& terrain, double x,
                          const FlipperDrive& front, const FlipperDrive& rear, double startPitch,
                          const GroundOptions& ground)
{
    if (!std::isfinite(x) || !std::isfinite(startPitch) || !isFinite(front) || !isFinite(rear))
        throw std::invalid_argument(
            "a rest pose needs a finite position, start pitch, angles and torques");
    const Pose high{{x, 0.0}, startPitch, startAngle(front), startAngle(rear)};
    RestPose rest = settle(robot, terrain, high, front, rear, ground, Start::Above);
    if (isPressed(front) && rest.pose.front < kLowestFlipper)
        rest = heldAtLowest(robot, terrain, rest, ground);
    for (int axle = 0; axle < 2; ++axle)
        rest = yielded(robot, terrain, rest, ground);  // one axle may overload the other
    if (!std::isfinite(rest.energy)) return Error{"no rest pose: the search diverges", 0};
    if (std::abs(rest.pose.pitch) > kMaxRestPitch)
        return Error{"no rest pose: the robot tips over", 0};
    if (isFolded(rest.front) || isFolded(rest.rear))
        return Error{"no rest pose: a flipper turned beyond 143 degrees lies on the robot", 0};
    if (std::max(std::abs(rest.pose.front), std::abs(rest.pose.rear)) > kMaxFlipper)
        return Error{"no rest pose: the flippers' motors cannot hold the robot", 0};
    return rest;
}

std::array<double, kForceElements> elementForces(const RobotModel& robot, const RestPose& rest)
{
    return edgeForces({robot.front, rest.pose.front, rest.pose}, robot.elementShare, rest.contacts,
                      GroundContact::Part::Front, 0.5);
}

Proprioception exactReadings(const RobotModel& robot, const RestPose& rest)
{
    Proprioception s;
    s.pitch = rest.pose.pitch;
    s.front = rest.pose.front;
    s.rear = rest.pose.rear;
    s.frontCurrent = 0.5 * rest.frontTorque / robot.torquePerAmpere;
    s.rearCurrent = 0.5 * rest.rearTorque / robot.torquePerAmpere;
    const auto force = elementForces(robot, rest);
    for (std::size_t e = 0; e < force.size(); ++e)
        s.force[e] = std::min(force[e], robot.forceSaturation);
    return s;
}

}  // namespace terratact
