#include "core/strip/dead_reckoning.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "tests/support/absolem.h"
#include "tests/support/dead_reckoning.h"

namespace terratact {
namespace {

TEST(DeadReckoning, rollsAlongThePitch)
{
    const double pitch = 0.3;
    const ImuMotion m = reckoned({{1.0, pitch}, {1.2, pitch}, {1.5, pitch}}).motion();
    EXPECT_NEAR(m.forward, 0.5 * std::cos(pitch), 1e-12);
    EXPECT_NEAR(m.up, 0.5 * std::sin(pitch), 1e-12);
    EXPECT_NEAR(m.way, 0.5, 1e-12);
    EXPECT_NEAR(m.slipForward, 0.10 * m.forward, 1e-12);
    EXPECT_NEAR(m.slipUp, 0.10 * m.up, 1e-12);
}

TEST(DeadReckoning, turnsTheImuAboutTheTracks)
{
    const RobotModel robot = absolem();
    const double height = robot.imu.z + robot.baseHeight;
    const ImuMotion m = reckoned({{0.0, 0.0}, {0.0, 0.2}}).motion();
    EXPECT_NEAR(m.forward, -height * std::sin(0.2), 1e-12);
    EXPECT_NEAR(m.up, height * (std::cos(0.2) - 1.0), 1e-12);
    EXPECT_NEAR(m.upSd, 0.2 * robot.trackAxle / std::sqrt(12.0), 1e-12);
    EXPECT_NEAR(reckoned({{0.0, 0.0}, {0.0, 0.2}, {0.0, 0.0}}).motion().upSd, m.upSd, 1e-12)
        << "it need not have turned back about the same point";
}

TEST(DeadReckoning, refusesNumbersThatAreNotFinite)
{
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(DeadReckoning(absolem(), kNan, 0.0), std::invalid_argument);
    DeadReckoning reckoning(absolem(), 0.0, 0.0);
    EXPECT_THROW(reckoning.add(0.0, kNan), std::invalid_argument);
    EXPECT_THROW(reckoning.add(kNan, 0.0), std::invalid_argument);
}

TEST(Odometry, seesACurveFromAbove)
{
    Odometry odometry(absolem(), {.travelled = 2.0, .turned = 3.0});
    constexpr int kSteps = 200;
    for (int k = 1; k <= kSteps; ++k) {
        const double share = static_cast<double>(k) / kSteps;
        const double turned = 3.0 + share * std::numbers::pi / 2.0;
        odometry.add({.travelled = 2.0 + share * std::numbers::pi / 2.0,
                      .turned = std::remainder(turned, 2.0 * std::numbers::pi)});
    }
    EXPECT_NEAR(odometry.now().heading, std::numbers::pi / 2.0, 1e-9)
        << "over the jump at half a turn";
    EXPECT_NEAR(odometry.now().planX, 1.0, 1e-4) << "a quarter of a circle of 1 m";
    EXPECT_NEAR(odometry.now().planY, 1.0, 1e-4);
}

TEST(Odometry, aFlickerWhileStandingIsNoWay)
{
    Odometry odometry(absolem(), {.travelled = 4.217});
    odometry.add({.travelled = 4.518});
    const double driven = odometry.now().way;
    for (int k = 0; k < 900; ++k) {  // 45 s of a probe
        const double digit =
            1e-3 * std::array{0.0, 1.0, 0.0, -1.0}.at(static_cast<std::size_t>(k % 4));
        odometry.add({.travelled = 4.518 + digit});
    }
    EXPECT_LE(odometry.now().way - driven, 0.001 + 1e-9) << "one count at most";
    EXPECT_NEAR(odometry.now().rolled.x, 0.302, 1e-9);
    odometry.add({.travelled = 4.818});
    EXPECT_NEAR(odometry.now().way, 0.601, 1e-9);
}

TEST(Odometry, aWayBackCountsAsAWhole)
{
    Odometry odometry(absolem(), {.travelled = 1.0});
    for (const double travelled : {1.3, 1.299, 1.298, 1.297, 1.296, 1.2})
        odometry.add({.travelled = travelled});
    EXPECT_NEAR(odometry.now().rolled.x, 0.2, 1e-12);
    EXPECT_NEAR(odometry.now().way, 0.4, 1e-12);
}

TEST(Odometry, oneDirectionCountsLineByLine)
{
    for (const double direction : {1.0, -1.0}) {
        Odometry odometry(absolem(), {.travelled = 0.7});
        double travelled = 0.7, sum = 0.0;
        for (int k = 0; k < 50; ++k) {
            const double next = travelled + direction * 1e-3 * (k % 3);
            sum += std::abs(next - travelled);
            travelled = next;
            odometry.add({.travelled = travelled});
            EXPECT_EQ(odometry.now().way, sum) << "bit for bit";
            EXPECT_EQ(odometry.now().line.travelled, travelled);
        }
    }
}

TEST(Odometry, rollAddsToTheHeightsSd)
{
    const RobotModel robot = absolem();
    const Odometry odometry(robot, {});
    const ImuMotion motion = odometry.motion(odometry.now(), odometry.now(), {.roll = 0.3});
    EXPECT_NEAR(motion.upSd, 0.3 * robot.lateral.trackY / std::sqrt(3.0), 1e-12);
}

TEST(CarriedSd, takesTheSlopeThatSlipHurtsMost)
{
    const ImuMotion motion{.slipForward = 0.05, .slipUp = 0.01, .upSd = 0.02};
    const double slopes[] = {0.3, -0.4};
    EXPECT_NEAR(carriedSd(motion, slopes), std::hypot(0.4 * 0.05 + 0.01, 0.02), 1e-12);
    EXPECT_NEAR(carriedSd(motion, {}), std::hypot(0.01, 0.02), 1e-12);
}

}  // namespace
}  // namespace terratact
