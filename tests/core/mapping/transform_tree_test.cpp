// Tests poses of frames in each other over time.
#include "core/mapping/transform_tree.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/bags/json_value.h"
#include "tests/support/transform_text.h"

namespace terratact {
namespace {

constexpr std::int64_t kTenth = 100'000'000;

/// Adds one transform that was sent at `stamp` and recorded 7 ns later.
void send(TransformTree& tree, const char* topic, std::string_view parent, std::string_view child,
          const FramePose& pose, std::int64_t stamp = 0)
{
    tree.add(topic, *jsonValue(transformText(parent, child, pose, stamp)), stamp + 7);
}

FramePose turned(double x, double y, double degrees)
{
    return {{x, y, 0.0},
            Eigen::Quaterniond(
                Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ()))};
}

TEST(TransformTree, chainsAreFollowedBothWays)
{
    TransformTree tree;
    send(tree, kFixedTransforms, "/base", "arm", turned(1.0, 0.0, 90.0));
    send(tree, kFixedTransforms, "arm", "imu", turned(2.0, 0.0, 90.0));
    const auto imu = tree.at("base", "/imu", 5);
    ASSERT_TRUE(imu);
    EXPECT_TRUE(imu->place.isApprox(Eigen::Vector3d(1, 2, 0), 1e-12)) << imu->place;
    EXPECT_TRUE(imu->toOther({1, 0, 0}).isApprox(Eigen::Vector3d(0, 2, 0), 1e-9));
    const auto back = tree.at("imu", "base", 5);
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->toOther({0, 2, 0}).isApprox(Eigen::Vector3d(1, 0, 0), 1e-9));
    EXPECT_FALSE(tree.at("base", "other", 5));
    EXPECT_FALSE(tree.joins("base", "other"));
    EXPECT_EQ(tree.links(), "base → arm, arm → imu");
}

TEST(TransformTree, loopsEnd)
{
    TransformTree tree;
    send(tree, kFixedTransforms, "a", "b", turned(1, 0, 0));
    send(tree, kFixedTransforms, "b", "a", turned(1, 0, 0));
    EXPECT_FALSE(tree.joins("a", "imu"));
    EXPECT_TRUE(tree.joins("b", "b"));
}

TEST(TransformTree, posesBetweenTwoTransformsAreInterpolated)
{
    TransformTree tree(0.15);
    for (const std::int64_t i : {0, 2, 1})  // not in order
        send(tree, kTransforms, "odom", "base", turned(0.1 * double(i), 0.0, 10.0 * double(i)),
             i * kTenth);
    send(tree, kTransforms, "odom", "base", turned(9.0, 0.0, 0.0), 10 * kTenth);
    const auto middle = tree.at("odom", "base", kTenth + kTenth / 2);
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->place.x(), 0.15, 1e-12);
    EXPECT_NEAR(middle->turn.angularDistance(turned(0, 0, 15.0).turn), 0.0, 1e-9);
    EXPECT_FALSE(tree.at("odom", "base", 5 * kTenth)) << "no transforms for 0.8 s";
    EXPECT_FALSE(tree.at("odom", "base", -kTenth));
    EXPECT_FALSE(tree.at("odom", "base", 11 * kTenth));
    EXPECT_TRUE(tree.at("odom", "base", 10 * kTenth + 900'000)) << "within 1 ms";
}

TEST(TransformTree, transformsThatNeverChangeHoldAlways)
{
    TransformTree tree;
    for (std::int64_t i = 0; i < 5; ++i)
        send(tree, kTransforms, "base", "imu", turned(0.1, 0.0, 90.0), i * kTenth);
    EXPECT_TRUE(tree.at("base", "imu", 1000 * kTenth));
    send(tree, kTransforms, "base", "imu", turned(0.2, 0.0, 90.0), 5 * kTenth);
    EXPECT_FALSE(tree.at("base", "imu", 1000 * kTenth));
    EXPECT_NEAR(tree.at("base", "imu", 2 * kTenth)->place.x(), 0.1, 1e-12) << "a long rest";
    EXPECT_NEAR(tree.at("base", "imu", 9 * kTenth / 2)->place.x(), 0.15, 1e-12);
}

TEST(TransformTree, stampsAreThoseOfTheBusiestLink)
{
    TransformTree tree;
    send(tree, kFixedTransforms, "base", "imu", turned(0.1, 0.0, 0.0));
    for (std::int64_t i = 0; i < 4; ++i)
        send(tree, kTransforms, "odom", "base", turned(0.1 * double(i), 0.0, 0.0), i * kTenth);
    for (std::int64_t i = 0; i < 2; ++i)
        send(tree, kTransforms, "map", "odom", turned(double(i), 0.0, 0.0), i * 3 * kTenth);
    const auto stamps = tree.stamps("map", "imu");
    ASSERT_EQ(stamps.size(), 4U);
    EXPECT_EQ(stamps[2].stamp, 2 * kTenth);
    EXPECT_EQ(stamps[2].recorded, 2 * kTenth + 7);
    EXPECT_NEAR(tree.at("map", "imu", kTenth)->place.x(), 1.0 / 3.0 + 0.1 + 0.1, 1e-6);
    EXPECT_TRUE(tree.stamps("map", "elsewhere").empty());
}

TEST(TransformTree, aFixedTransformComesBeforeOthers)
{
    TransformTree tree;
    send(tree, kTransforms, "base", "imu", turned(0.1, 0.0, 0.0), kTenth);
    send(tree, kFixedTransforms, "base", "imu", turned(0.5, 0.0, 0.0));
    send(tree, kTransforms, "base", "imu", turned(0.7, 0.0, 0.0), 2 * kTenth);
    send(tree, kTransforms, "other", "imu", turned(0.7, 0.0, 0.0), 2 * kTenth);
    EXPECT_NEAR(tree.at("base", "imu", kTenth)->place.x(), 0.5, 1e-12);
}

TEST(TransformTree, brokenTransformsAreIgnored)
{
    TransformTree tree;
    FramePose pose = turned(0.1, 0.0, 0.0);
    pose.turn.coeffs().setZero();
    send(tree, kFixedTransforms, "base", "imu", pose);
    tree.add(kFixedTransforms, *jsonValue(R"({"transforms":[{"child_frame_id":"imu"}]})"), 0);
    tree.add("/other", *jsonValue(transformText("base", "imu", turned(1, 0, 0), 0)), 0);
    EXPECT_FALSE(tree.joins("base", "imu"));
    EXPECT_EQ(tree.links(), "none");
}

TEST(TransformTree, unusedFramesTakeNoMemory)
{
    TransformTree tree;
    tree.want("imu");
    send(tree, kTransforms, "base", "imu", turned(0.0, 0.0, 0.0), 0);
    send(tree, kTransforms, "base", "imu", turned(0.1, 0.0, 0.0), kTenth);
    const auto value = *jsonValue(transformText("base", "wheel", turned(0.0, 0.0, 1.0), kTenth));
    const auto other = *jsonValue(transformText("base", "wheel", turned(0.0, 0.0, 2.0), kTenth));
    for (int i = 0; i < 260'000; ++i) {
        tree.add(kTransforms, value, 0);
        tree.add(kTransforms, other, 0);
    }
    EXPECT_LT(tree.stamps("base", "wheel").size(), 2U);
    EXPECT_NEAR(tree.at("base", "imu", kTenth / 2)->place.x(), 0.05, 1e-6);
}

}  // namespace
}  // namespace terratact
