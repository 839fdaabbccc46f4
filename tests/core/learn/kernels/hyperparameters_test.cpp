#include "core/learn/kernels/hyperparameters.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "core/learn/data/columns.h"

namespace terratact {
namespace {

Proprioception counted()
{
    Proprioception s{
        .pitch = 0.1, .front = 0.2, .rear = 0.3, .frontCurrent = 4.0, .rearCurrent = 5.0};
    for (std::size_t i = 0; i < s.force.size(); ++i) s.force[i] = 6.0 + static_cast<double>(i);
    return s;
}

TEST(Features, comeInTheOrderOfTheirNames)
{
    using Names = std::vector<std::string_view>;
    EXPECT_EQ(featureNames(FeatureSet::Pa), (Names{"pitch_rad", "front_rad", "rear_rad"}));
    EXPECT_EQ(
        featureNames(FeatureSet::Paf),
        (Names{"pitch_rad", "front_rad", "rear_rad", "front_current_a", "rear_current_a",
               "force_1_n", "force_2_n", "force_3_n", "force_4_n", "force_5_n", "force_6_n"}));
    EXPECT_EQ(features(FeatureSet::Pa, counted()), Eigen::Vector3d(0.1, 0.2, 0.3));
    Eigen::VectorXd all(11);
    all << 0.1, 0.2, 0.3, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0;
    EXPECT_EQ(features(FeatureSet::Paf, counted()), all);
}

TEST(Features, nameTheirSets)
{
    EXPECT_EQ(name(FeatureSet::Pa), "pa");
    EXPECT_EQ(name(FeatureSet::Paf), "paf");
}

TEST(Features, nameTheFirstThatIsMissing)
{
    EXPECT_EQ(missingFeature(FeatureSet::Paf, counted()), "");
    for (std::size_t i = 3; i < kFeatures; ++i) {
        FeatureValues values = featureValues(counted());
        values[i].reset();
        values.back().reset();
        const Proprioception s = proprioception(values);
        EXPECT_EQ(missingFeature(FeatureSet::Paf, s), featureNames(FeatureSet::Paf)[i]);
        EXPECT_EQ(missingFeature(FeatureSet::Pa, s), "");
        EXPECT_NO_THROW(features(FeatureSet::Pa, s));
        EXPECT_THROW(features(FeatureSet::Paf, s), std::invalid_argument);
    }
}

TEST(FeatureValues, convertToProprioceptionAndBack)
{
    EXPECT_EQ(proprioception(featureValues(counted())), counted());
    FeatureValues noPitch = featureValues(counted());
    noPitch[0].reset();
    EXPECT_THROW(proprioception(noPitch), std::invalid_argument);
}

TEST(Columns, nameEveryHeightByItsBin)
{
    for (int i = 0; i < kBins; ++i) {
        char expected[16];
        std::snprintf(expected, sizeof expected, "h_%+.1f_m", binCentre(i));
        EXPECT_EQ(heightColumns()[static_cast<std::size_t>(i)].name, expected);
    }
}

TEST(Columns, refuseNanAndValuesBeyondTheirRange)
{
    const Column& height = heightColumns()[0];
    EXPECT_TRUE(height.holds(-5.0) && height.holds(5.0));
    EXPECT_FALSE(height.holds(5.0001) || height.holds(std::nan("")));
    EXPECT_NE(height.refusal(200.0).english().find("mm"), std::string::npos);
}

}  // namespace
}  // namespace terratact
