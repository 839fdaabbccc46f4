#include "core/learn/data/side_features.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

TwoTrackReadings someReadings()
{
    TwoTrackReadings s;
    s.pitch = 0.1;
    s.roll = -0.2;
    s.flippers = {0.1, 0.2, 0.3, 0.4};
    s.currents = {1.0, 2.0, 3.0, 4.0};
    for (std::size_t e = 0; e < std::size_t{kForceElements}; ++e) {
        s.forces[0][e] = 1.0 + static_cast<double>(e);
        s.forces[1][e] = 11.0 + static_cast<double>(e);
    }
    return s;
}

TEST(SideFeatures, ofTheRightSideAreThoseOfTheMirrorImage)
{
    const TwoTrackReadings s = someReadings();
    EXPECT_EQ(sideFeatures(s, Side::Right), sideFeatures(mirrored(s), Side::Left));
    EXPECT_EQ(sideFeatures(s, Side::Left)[1], -0.2);
    EXPECT_EQ(sideFeatures(s, Side::Right)[1], 0.2);
    EXPECT_EQ(readingsOf(sideFeatures(s, Side::Left)), s);
    EXPECT_EQ(readingsOf(sideFeatures(s, Side::Right)), mirrored(s));
}

TEST(SideFeatures, ofBothSidesHaveTheSameOrder)
{
    const Eigen::VectorXd left = sideFeatures(someReadings(), Side::Left);
    const Eigen::VectorXd right = sideFeatures(someReadings(), Side::Right);
    for (std::size_t d = 2; d < kSideFeatures; ++d) {
        EXPECT_EQ(right[static_cast<Eigen::Index>(d)],
                  left[static_cast<Eigen::Index>(otherSideFeature(d))])
            << d;
        EXPECT_EQ(otherSideFeature(otherSideFeature(d)), d);
    }
}

TEST(SideFeatures, sayWhatOneSideLacks)
{
    TwoTrackReadings s = someReadings();
    EXPECT_TRUE(absentFeatures(s, Side::Left).none());
    s.forces[indexOf(Flipper::FrontRight)] = {};
    s.currents[indexOf(Flipper::RearLeft)].reset();
    const AbsentFeatures left = absentFeatures(s, Side::Left);
    const AbsentFeatures right = absentFeatures(s, Side::Right);
    EXPECT_EQ(left.count(), 7U);
    EXPECT_TRUE(left[kFirstSideCurrent + 1] && left[kFirstSideForce + 6]);
    EXPECT_TRUE(right[kFirstSideCurrent + 3] && right[kFirstSideForce]);
}

}  // namespace
}  // namespace terratact
