#include "core/atem/pose_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include "core/atem/drive_watch.h"
#include "core/atem/stall_watch.h"

#include "core/sim/sensor_noise.h"

namespace terratact {
namespace {

Measurement scene()
{
    Measurement m;
    m.pitch = 0.2;
    m.roll = -0.05;
    m.frontLeft = m.frontRight = -0.5;
    m.rearLeft = m.rearRight = 0.3;
    m.activity = RobotActivity::Pressed;
    m.travelled = 7.0;
    m.turned = std::numbers::pi;  // where it wraps
    return m;
}

struct Change {
    std::string name;
    std::function<void(Measurement&, double)> by;
    double limit;  ///< [rad], of travelled [m]
};

class PoseChange : public testing::TestWithParam<Change> {};

TEST_P(PoseChange, isAMoveBeyondItsLimit)
{
    for (const double sign : {-1.0, 1.0}) {
        PoseWatch watch(scene());
        Measurement m = scene();
        GetParam().by(m, sign * (GetParam().limit - 1e-6));
        watch.poll(m, 1);
        watch.poll(m, 2);
        EXPECT_FALSE(watch.hasMoved());
        GetParam().by(m, sign * 2e-6);
        watch.poll(m, 3);
        watch.poll(m, 4);
        EXPECT_TRUE(watch.hasMoved());
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, PoseChange,
    testing::Values(
        Change{"pitch", [](Measurement& m, double d) { m.pitch += d; }, PoseWatch::kTilt},
        Change{"roll", [](Measurement& m, double d) { m.roll += d; }, PoseWatch::kTilt},
        Change{"front", [](Measurement& m, double d) { m.frontLeft += d, m.frontRight += d; },
               PoseWatch::kFlipper},
        Change{"rear", [](Measurement& m, double d) { m.rearLeft += d, m.rearRight += d; },
               PoseWatch::kFlipper},
        Change{"frontLeft", [](Measurement& m, double d) { m.frontLeft += d; },
               PoseWatch::kFlipper},
        Change{"frontRight", [](Measurement& m, double d) { m.frontRight += d; },
               PoseWatch::kFlipper},
        Change{"rearLeft", [](Measurement& m, double d) { m.rearLeft += d; }, PoseWatch::kFlipper},
        Change{"rearRight", [](Measurement& m, double d) { m.rearRight += d; },
               PoseWatch::kFlipper},
        Change{"oppositeFront",
               [](Measurement& m, double d) { m.frontLeft += d, m.frontRight -= d; },
               PoseWatch::kFlipper},
        Change{"oppositeRear", [](Measurement& m, double d) { m.rearLeft += d, m.rearRight -= d; },
               PoseWatch::kFlipper},
        Change{"travelled", [](Measurement& m, double d) { *m.travelled += d; },
               PoseWatch::kTravelled},
        Change{"turned",
               [](Measurement& m, double d) {
                   *m.turned = std::remainder(*m.turned + d, 2.0 * std::numbers::pi);
               },
               PoseWatch::kTurned}),
    [](const auto& change) { return change.param.name; });

TEST(PoseWatch, limitsLieJustAboveElasticGive)
{
    const std::pair<const char*, std::function<void(Measurement&)>> moves[]{
        {"4 degrees of pitch", [](Measurement& m) { m.pitch += 0.07; }},
        {"4 degrees of roll", [](Measurement& m) { m.roll -= 0.07; }},
        {"3.5 degrees of a flipper", [](Measurement& m) { m.rearLeft += 0.06; }},
        {"3 cm", [](Measurement& m) { *m.travelled -= 0.03; }},
        {"3.5 degrees on the spot", [](Measurement& m) { *m.turned -= 0.06; }}};
    for (const auto& [name, move] : moves) {
        PoseWatch watch(scene());
        Measurement m = scene();
        move(m);
        watch.poll(m, 1);
        watch.poll(m, 2);
        EXPECT_TRUE(watch.hasMoved()) << name;
    }
}

TEST(PoseWatch, comparesTracksOnlyIfBothLinesHaveOdometry)
{
    Measurement without = scene();
    without.travelled.reset();
    without.turned.reset();
    for (const auto& [first, then] : {std::pair(without, scene()), std::pair(scene(), without)}) {
        PoseWatch watch(first);
        watch.poll(then, 1);
        watch.poll(then, 2);
        EXPECT_FALSE(watch.hasMoved());
    }
}

TEST(PoseWatch, ignoresTenMinutesOfSensorNoise)
{
    const SensorNoise noise;
    std::mt19937_64 rng(20150205);
    const auto measured = [&] {
        const auto with = [&](double value, double sd) {
            return value + sd * std::normal_distribution<double>()(rng);
        };
        Measurement m = scene();
        for (double* const angle : {&m.pitch, &m.roll}) *angle = with(*angle, noise.pitch);
        for (double* const angle : {&m.frontLeft, &m.frontRight, &m.rearLeft, &m.rearRight})
            *angle = with(*angle, noise.flipperAngle);
        *m.travelled = std::round(*m.travelled * 1e3) * 1e-3;  // as on the wire
        return m;
    };
    for (int run = 0; run < 20; ++run) {
        PoseWatch watch(measured());
        for (std::uint64_t line = 1; line <= 12000; ++line) watch.poll(measured(), line);  // 20 Hz
        EXPECT_FALSE(watch.hasMoved()) << "run " << run;
    }
}

TEST(PoseWatch, countsDrivingAsAMove)
{
    PoseWatch watch(scene());
    Measurement m = scene();
    m.activity = RobotActivity::Driving;
    watch.poll(m, 7);
    watch.poll(m, 8);
    EXPECT_TRUE(watch.hasMoved());
}

TEST(PoseWatch, needsTwoLinesInARow)
{
    PoseWatch watch(scene());
    Measurement away = scene();
    away.pitch += 0.1;
    watch.poll(away, 1);
    watch.poll(away, 1);
    EXPECT_FALSE(watch.hasMoved()) << "the same line again";
    watch.poll(scene(), 2);
    watch.poll(away, 3);
    EXPECT_FALSE(watch.hasMoved()) << "an outlier each";
    watch.poll(away, 4);
    EXPECT_TRUE(watch.hasMoved());
    watch.poll(scene(), 5);
    watch.poll(scene(), 6);
    EXPECT_TRUE(watch.hasMoved()) << "the scene is not the same any more";
}

TEST(PoseWatch, driveWithoutMotionDoesNotLeaveThePlace)
{
    Measurement scene;
    scene.travelled = 1.0;
    scene.turned = 0.0;
    PoseWatch watch(scene);
    Measurement m = scene;
    m.activity = RobotActivity::Driving;
    m.frontLeft += 0.5;  // the flipper rises first
    for (std::uint64_t count = 1; count <= 20; ++count) watch.poll(m, count);
    EXPECT_TRUE(watch.hasMoved()) << "another pose to rest on";
    EXPECT_FALSE(watch.hasLeft());
    *m.travelled += PoseWatch::kTravelled + 0.001;
    watch.poll(m, 21);
    EXPECT_FALSE(watch.hasLeft()) << "one outlier";
    watch.poll(m, 22);
    EXPECT_TRUE(watch.hasLeft());
    watch.poll(scene, 23);
    EXPECT_TRUE(watch.hasLeft()) << "once left it stays left";
}

TEST(PoseWatch, aDriveWithoutOdometryLeavesThePlace)
{
    PoseWatch watch(Measurement{});
    Measurement m;
    m.activity = RobotActivity::Driving;
    watch.poll(m, 1);
    watch.poll(m, 2);
    EXPECT_TRUE(watch.hasLeft());
}

TEST(DriveWatch, reportsADriveWithoutMotionOnce)
{
    DriveWatch watch;
    Measurement m;
    m.activity = RobotActivity::Driving;
    m.travelled = 0.0;
    double now = 10.0;
    const auto pass = [&](double seconds, double speed) {
        int told = 0;
        for (int i = 0; i < static_cast<int>(seconds / 0.05 + 0.5); ++i) {
            *m.travelled += speed * 0.05;
            told += watch.poll(m, now += 0.05);
        }
        return told;
    };
    EXPECT_EQ(pass(5.0, 0.2), 0);
    EXPECT_EQ(pass(5.0, 0.0), 1);
    EXPECT_EQ(pass(1.0, -0.2), 0);
    EXPECT_EQ(pass(5.0, 0.0), 1) << "anew after a move";
    m.activity = RobotActivity::Halted;
    EXPECT_EQ(pass(5.0, 0.0), 0);
}

TEST(StallWatch, returnsThePauseBetweenPolls)
{
    StallWatch watch;
    EXPECT_FALSE(watch.poll(5.0)) << "nothing came before";
    EXPECT_FALSE(watch.poll(5.01));
    EXPECT_FALSE(watch.poll(5.1));
    const auto frozen = watch.poll(5.41);
    ASSERT_TRUE(frozen);
    EXPECT_NEAR(*frozen, 0.31, 1e-12);
    EXPECT_FALSE(watch.poll(5.43));
}

}  // namespace
}  // namespace terratact
