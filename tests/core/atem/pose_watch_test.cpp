#include "core/atem/pose_watch.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace terratact {
namespace {

Measurement scene()
{
    Measurement m;
    m.pitch = 0.2;
    m.frontLeft = m.frontRight = -0.5;
    m.rearLeft = m.rearRight = 0.3;
    m.activity = RobotActivity::Pressed;
    return m;
}

struct Change {
    std::string name;
    std::function<void(Measurement&, double)> by;
    double limit;  ///< [rad]
};

class PoseChange : public testing::TestWithParam<Change> {};

TEST_P(PoseChange, isAMoveBeyondItsLimit)
{
    for (const double sign : {-1.0, 1.0}) {
        PoseWatch watch(scene());
        Measurement m = scene();
        GetParam().by(m, sign * (GetParam().limit - 1e-6));
        watch.look(m, 1);
        watch.look(m, 2);
        EXPECT_FALSE(watch.hasMoved());
        GetParam().by(m, sign * 2e-6);
        watch.look(m, 3);
        watch.look(m, 4);
        EXPECT_TRUE(watch.hasMoved());
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, PoseChange,
    testing::Values(
        Change{"pitch", [](Measurement& m, double d) { m.pitch += d; }, PoseWatch::kPitchChange},
        Change{"front", [](Measurement& m, double d) { m.frontLeft += d, m.frontRight += d; },
               PoseWatch::kFlipperChange},
        Change{"rear", [](Measurement& m, double d) { m.rearLeft += d, m.rearRight += d; },
               PoseWatch::kFlipperChange}),
    [](const auto& change) { return change.param.name; });

TEST(PoseWatch, takesDrivingForAMove)
{
    PoseWatch watch(scene());
    Measurement m = scene();
    m.activity = RobotActivity::Driving;
    watch.look(m, 7);
    watch.look(m, 8);
    EXPECT_TRUE(watch.hasMoved());
}

TEST(PoseWatch, believesTwoLinesInARow)
{
    PoseWatch watch(scene());
    Measurement away = scene();
    away.pitch += 0.1;
    watch.look(away, 1);
    watch.look(away, 1);
    EXPECT_FALSE(watch.hasMoved()) << "the same line again";
    watch.look(scene(), 2);
    watch.look(away, 3);
    EXPECT_FALSE(watch.hasMoved()) << "an outlier each";
    watch.look(away, 4);
    EXPECT_TRUE(watch.hasMoved());
    watch.look(scene(), 5);
    watch.look(scene(), 6);
    EXPECT_TRUE(watch.hasMoved()) << "the scene is not the same any more";
}

}  // namespace
}  // namespace terratact
