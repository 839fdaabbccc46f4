#include "core/sim/rest/two_track_potential.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/sim/rest/two_track_rest.h"
#include "tests/core/sim/rest/some_ground.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

/// Returns a pose some millimetres inside of the ground, so that many springs are compressed.
TwoTrackPose pressedIn(const TwoTrackPose& rest, std::mt19937_64& rng)
{
    std::uniform_real_distribution<double> some(-0.02, 0.02);
    TwoTrackPose pose = rest;
    pose.base.z -= 0.003;
    pose.pitch += some(rng);
    pose.roll += some(rng);
    pose.differential += some(rng);
    for (double& angle : pose.flippers) angle += some(rng);
    return pose;
}

TwoTrackPose shifted(TwoTrackPose pose, int coordinate, double way)
{
    using C = TwoTrackCoordinate;
    auto& [frontLeft, frontRight, rearLeft, rearRight] = pose.flippers;
    switch (coordinate) {
    case C::Z: pose.base.z += way; break;
    case C::Pitch: pose.pitch += way; break;
    case C::FrontMean: frontLeft += way, frontRight += way; break;
    case C::RearMean: rearLeft += way, rearRight += way; break;
    case C::Roll: pose.roll += way; break;
    case C::FrontHalf: frontLeft += way, frontRight -= way; break;
    case C::RearHalf: rearLeft += way, rearRight -= way; break;
    default: pose.differential += way;
    }
    return pose;
}

TEST(TwoTrackPotential, hasTheDerivativesOfItsEnergy)
{
    RobotModel robot = absolem();
    robot.lateral.bodyComY = 0.03;
    std::mt19937_64 rng(3);
    constexpr double kWay = 1e-7;
    for (int run = 0; run < 10; ++run) {
        const GroundLines ground = someGround(rng);
        const double x = placeOn(ground, rng);
        const auto rest = restPose(robot, ground, x, kDrives);
        if (!rest) continue;
        const TwoTrackPotential potential(robot, ground, x, kDrives, {});
        const TwoTrackPose pose = pressedIn(rest->pose, rng);
        TwoTrackDerivatives here, low, high;
        const double stiffness = 1e4;
        potential(pose, stiffness, &here, nullptr);
        for (int i = 0; i < TwoTrackCoordinate::Count; ++i) {
            const double below = potential(shifted(pose, i, -kWay), stiffness, &low, nullptr);
            const double above = potential(shifted(pose, i, kWay), stiffness, &high, nullptr);
            const double slope = (above - below) / (2.0 * kWay);
            EXPECT_NEAR(here.gradient[i], slope, 1e-5 * (1.0 + here.gradient.norm())) << i;
            const TwoTrackVector column = (high.gradient - low.gradient) / (2.0 * kWay);
            EXPECT_LT((here.hessian.col(i) - column).norm(), 1e-5 * (1.0 + here.hessian.norm()))
                << "run " << run << " coordinate " << i;
        }
    }
}

TEST(TwoTrackRest, isALocalMinimumOfTheEnergy)
{
    const RobotModel robot = absolem();
    std::mt19937_64 rng(17);
    std::normal_distribution<double> normal;
    int tested = 0;
    for (int run = 0; run < 8; ++run) {
        const GroundLines ground = someGround(rng);
        const double x = placeOn(ground, rng);
        const auto rest = restPose(robot, ground, x, kDrives);
        if (!rest) continue;
        const TwoTrackPotential potential(robot, ground, x, rest->drives, {});
        for (int k = 0; k < 1000; ++k) {
            const double size = std::pow(10.0, -1.0 - 4.0 * (k % 5) / 4.0);
            TwoTrackPose pose = rest->pose;
            pose.base.z += 0.01 * size * normal(rng);
            pose.pitch += 0.03 * size * normal(rng);
            pose.roll += 0.03 * size * normal(rng);
            for (std::size_t i = 0; i < kFlippers; ++i)
                if (isPressed(rest->drives[i])) pose.flippers[i] += 0.1 * size * normal(rng);
            EXPECT_GE(potential(pose, GroundOptions{}.stiffness, nullptr, nullptr),
                      rest->energy - 1e-8)
                << "run " << run << " perturbation " << k;
        }
        ++tested;
    }
    EXPECT_GE(tested, 6);
}

}  // namespace
}  // namespace terratact
