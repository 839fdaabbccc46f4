#include "core/sim/rest/two_track_rest.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>

#include "core/sim/rest/edge_forces.h"
#include "core/sim/rest/newton_descent.h"
#include "core/sim/rest/rest_search.h"

namespace terratact {
namespace {

using Axis = TwoTrackCoordinate;

/// Two-track problem for NewtonDescent. It moves in the space of the free coordinates only.
class TwoTrackProblem {
public:
    using State = TwoTrackPose;
    using Vector = TwoTrackVector;
    using Derivatives = TwoTrackDerivatives;

    TwoTrackProblem(const TwoTrackPotential& potential, const PerFlipper<FlipperDrive>& drives,
                    bool differentialFree)
        : potential_(potential), drives_(drives)
    {
        add({{Axis::Z, 1.0}});
        add({{Axis::Pitch, 1.0}});
        addAxle(drives, Flipper::FrontLeft, Flipper::FrontRight, Axis::FrontMean, Axis::FrontHalf);
        addAxle(drives, Flipper::RearLeft, Flipper::RearRight, Axis::RearMean, Axis::RearHalf);
        add({{Axis::Roll, 1.0}});
        if (differentialFree) add({{Axis::Differential, 1.0}});
    }

    double energy(const TwoTrackPose& pose, double stiffness, Derivatives& derivatives) const
    {
        return potential_(pose, stiffness, &derivatives, nullptr);
    }

    Vector step(const TwoTrackPose&, double, const Derivatives& derivatives) const
    {
        const auto basis = free_.leftCols(count_);
        const FreeMatrix h = basis.transpose() * derivatives.hessian * basis;
        const FreeVector g = basis.transpose() * derivatives.gradient;
        const Vector step = basis * direction(h, g);
        const double front = std::abs(step[Axis::FrontMean]) + std::abs(step[Axis::FrontHalf]);
        const double rear = std::abs(step[Axis::RearMean]) + std::abs(step[Axis::RearHalf]);
        const double turn = std::max({std::abs(step[Axis::Pitch]), std::abs(step[Axis::Roll]),
                                      std::abs(step[Axis::Differential]), front, rear});
        const double longest = std::max(std::abs(step[Axis::Z]) / 0.02, turn / 0.1);
        return longest > 1.0 ? Vector(step / longest) : step;
    }

    static TwoTrackPose moved(TwoTrackPose pose, const Vector& step)
    {
        pose.base.z += step[Axis::Z];
        pose.pitch += step[Axis::Pitch];
        pose.roll += step[Axis::Roll];
        pose.differential += step[Axis::Differential];
        pose.flippers[indexOf(Flipper::FrontLeft)] += step[Axis::FrontMean] + step[Axis::FrontHalf];
        pose.flippers[indexOf(Flipper::FrontRight)] +=
            step[Axis::FrontMean] - step[Axis::FrontHalf];
        pose.flippers[indexOf(Flipper::RearLeft)] += step[Axis::RearMean] + step[Axis::RearHalf];
        pose.flippers[indexOf(Flipper::RearRight)] += step[Axis::RearMean] - step[Axis::RearHalf];
        return pose;
    }

    /// Returns true if a pressed flipper fell around the robot: it found no ground.
    bool isLost(const TwoTrackPose& pose) const
    {
        for (std::size_t i = 0; i < kFlippers; ++i)
            if (isPressed(drives_[i]) && pose.flippers[i] < -kMaxFlipper) return true;
        return false;
    }

private:
    using FreeMatrix =
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Axis::Count, Axis::Count>;
    using FreeVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Axis::Count, 1>;
    struct Entry {
        int coordinate;
        double value;
    };

    void add(std::initializer_list<Entry> entries)
    {
        for (const Entry& entry : entries) free_(entry.coordinate, count_) = entry.value;
        ++count_;
    }

    /// Adds the free flippers of an axle. One free flipper moves the mean and the half alike.
    void addAxle(const PerFlipper<FlipperDrive>& drives, Flipper left, Flipper right, int mean,
                 int half)
    {
        const bool leftFree = isPressed(drives[indexOf(left)]);
        const bool rightFree = isPressed(drives[indexOf(right)]);
        if (leftFree && rightFree) {
            add({{mean, 1.0}});
            add({{half, 1.0}});
        } else if (leftFree || rightFree) {
            const double share = std::sqrt(0.5);
            add({{mean, share}, {half, leftFree ? share : -share}});
        }
    }

    /// Returns newtonStep(). If every eigenvalue is above 1 it needs no eigenvectors.
    static FreeVector direction(const FreeMatrix& h, const FreeVector& g)
    {
        const FreeMatrix above = h - FreeMatrix::Identity(h.rows(), h.cols());
        if (above.llt().info() == Eigen::Success) return -h.llt().solve(g);
        return newtonStep(h, g);
    }

    const TwoTrackPotential& potential_;
    const PerFlipper<FlipperDrive>& drives_;
    TwoTrackMatrix free_ = TwoTrackMatrix::Zero();  ///< its first `count_` columns span the space
    Eigen::Index count_ = 0;
};

/// Search for a rest pose at one place.
class RestSearch {
public:
    RestSearch(const RobotModel& robot, const GroundLines& terrain,
               const PerFlipper<FlipperDrive>& drives, const TwoTrackPose& pose,
               const GroundOptions& ground)
        : robot_(robot), terrain_(terrain), ground_(ground)
    {
        rest_.pose = pose;
        rest_.drives = drives;
    }

    TwoTrackRest run()
    {
        settle(Start::Above);
        keepWithinReach();
        // A flipper that gives way may overload another one.
        for (std::size_t k = 0; k < kFlippers && yield(); ++k) {
            settle(Start::Here);
            keepWithinReach();
        }
        return std::move(rest_);
    }

private:
    /// Stops the differential at its limit, and holds flippers that hang, until nothing has moved
    /// beyond its reach. A part that is stopped may let another one lose the ground.
    void keepWithinReach()
    {
        for (std::size_t k = 0; k <= kFlippers && (limitDifferential() || holdHanging()); ++k)
            settle(Start::Above);
    }

    /// Stops a differential that turned too far. Returns true if it did.
    bool limitDifferential()
    {
        const double limit = robot_.differential.limit;
        if (std::abs(rest_.pose.differential) <= limit) return false;
        rest_.differentialAtLimit = true;
        rest_.pose.differential = std::copysign(limit, rest_.pose.differential);
        return true;
    }

    void settle(Start start)
    {
        const TwoTrackPotential potential(robot_, terrain_, rest_.pose.base.x, rest_.drives,
                                          ground_);
        const bool turns = !robot_.differential.locked && !rest_.differentialAtLimit;
        const TwoTrackProblem problem(potential, rest_.drives, turns);
        NewtonDescent descent(problem, ground_.settled);
        if (start == Start::Above) rest_.pose.base.z = potential.clearHeight(rest_.pose);
        lower(descent, rest_.pose, ground_.stiffness, start);

        rest_.contacts = {};
        TwoTrackDerivatives d;
        rest_.energy = potential(rest_.pose, ground_.stiffness, &d, &rest_.contacts);
        const auto setTorques = [&](Flipper left, Flipper right, int mean, int half) {
            // E by the left angle is half of the sum of its derivatives by mean and half.
            const double byMean = 0.5 * d.gradient[mean], byHalf = 0.5 * d.gradient[half];
            rest_.torques[indexOf(left)] =
                torqueOf(rest_.drives[indexOf(left)]) - (byMean + byHalf);
            rest_.torques[indexOf(right)] =
                torqueOf(rest_.drives[indexOf(right)]) - (byMean - byHalf);
        };
        setTorques(Flipper::FrontLeft, Flipper::FrontRight, Axis::FrontMean, Axis::FrontHalf);
        setTorques(Flipper::RearLeft, Flipper::RearRight, Axis::RearMean, Axis::RearHalf);
        rest_.iterations += descent.iterations();
        rest_.terrainPoints += potential.terrainPoints();
    }

    /// Holds pressed flippers that found no ground. One that gave way is not pressed by choice, and
    /// falls. Returns true if there was one.
    bool holdHanging()
    {
        bool any = false;
        for (std::size_t i = 0; i < kFlippers; ++i) {
            if (!isPressed(rest_.drives[i]) || rest_.gaveWay[i]) continue;
            if (rest_.pose.flippers[i] >= kLowestFlipper) continue;
            rest_.drives[i] = HoldAngle{kLowestFlipper};
            rest_.pose.flippers[i] = kLowestFlipper;
            rest_.hangs[i] = any = true;
        }
        return any;
    }

    /// Lets held flippers with overloaded motors give way. Returns true if there was one.
    bool yield()
    {
        bool any = false;
        for (std::size_t i = 0; i < kFlippers; ++i) {
            const FlipperDrive drive =
                sustained(rest_.drives[i], rest_.torques[i], robot_.maxFlipperTorque);
            if (isPressed(drive) == isPressed(rest_.drives[i])) continue;
            rest_.drives[i] = drive;
            rest_.gaveWay[i] = any = true;
        }
        return any;
    }

    const RobotModel& robot_;
    const GroundLines& terrain_;
    GroundOptions ground_;
    TwoTrackRest rest_;
};

Status checkRest(const TwoTrackRest& rest)
{
    if (!std::isfinite(rest.energy)) return Error{"no rest pose: the search diverges", 0};
    if (std::abs(rest.pose.pitch) > kMaxRestPitch)
        return Error{"no rest pose: the robot tips over", 0};
    if (std::abs(rest.pose.roll) > kMaxRestRoll)
        return Error{"no rest pose: the robot tips over sideways", 0};
    if (std::ranges::any_of(rest.drives, isFolded))
        return Error{"no rest pose: a flipper turned beyond 143 degrees lies on the robot", 0};
    for (const double angle : rest.pose.flippers)
        if (std::abs(angle) > kMaxFlipper)
            return Error{"no rest pose: the flippers' motors cannot hold the robot", 0};
    return Done{};
}

}  // namespace

PerFlipper<FlipperDrive> flipperDrives(const FlipperDrive& front, const FlipperDrive& rear)
{
    const auto single = [](FlipperDrive drive) {
        if (auto* press = std::get_if<PressTorque>(&drive)) press->torque *= 0.5;
        return drive;
    };
    return {single(front), single(front), single(rear), single(rear)};
}

Result<TwoTrackRest> restPose(const RobotModel& robot, const GroundLines& terrain, double x,
                              const PerFlipper<FlipperDrive>& drives, const RestStart& start,
                              const GroundOptions& ground)
{
    if (!std::isfinite(x) || !std::isfinite(start.pitch) || !std::isfinite(start.roll)
        || !std::ranges::all_of(drives, isFinite))
        throw std::invalid_argument(
            "a rest pose needs a finite position, attitude, angles and torques");
    TwoTrackPose pose{.base = {x, 0.0}, .pitch = start.pitch, .roll = start.roll};
    std::ranges::transform(drives, pose.flippers.begin(), startAngle);
    TwoTrackRest rest = RestSearch(robot, terrain, drives, pose, ground).run();
    if (const Status status = checkRest(rest); !status) return status.error();
    return rest;
}

TwoTrackReadings exactReadings(const RobotModel& robot, const TwoTrackRest& rest)
{
    TwoTrackReadings readings;
    readings.pitch = rest.pose.pitch;
    readings.roll = rest.pose.roll;
    readings.flippers = rest.pose.flippers;
    if (!robot.differential.locked) readings.differential = rest.pose.differential;
    for (std::size_t i = 0; i < kFlippers; ++i)
        readings.currents[i] = rest.torques[i] / robot.torquePerAmpere;
    for (const Side side : {Side::Left, Side::Right}) {
        const Pose plane = sidePose(robot, rest.pose, side, robot.lateral.flipperY);
        const auto& contacts = rest.contacts[indexOf(side)];
        const auto read = [&](Flipper flipper, const FlipperEdge& edge, const auto& shares,
                              GroundContact::Part part, auto has) {
            const auto forces = edgeForces(edge, shares, contacts, part, 1.0);
            for (std::size_t e = 0; e < forces.size(); ++e)
                if (has(static_cast<int>(e)))
                    readings.forces[indexOf(flipper)][e] =
                        std::min(forces[e], robot.forceSaturation);
        };
        read(frontFlipper(side), {robot.front, plane.front, plane}, robot.elementShare,
             GroundContact::Part::Front,
             [&](int e) { return haveElement(robot.forceArrays, side, e); });
        if (robot.rearElementShare)
            read(rearFlipper(side), {robot.rear, plane.rear, plane}, *robot.rearElementShare,
                 GroundContact::Part::Rear, [](int) { return true; });
    }
    return readings;
}

}  // namespace terratact
